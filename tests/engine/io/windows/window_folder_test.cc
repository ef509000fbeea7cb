#include <gable/engine/io/models/building_file.h>
#include <gable/engine/io/windows/window_folder.h>

#include <map>
#include <memory>

#include "engine/io/sample_building.h"
#include "engine/io/scratch.h"

namespace gable {
namespace {

namespace fs = std::filesystem;

class WindowFolderTest : public testing::Test {
 protected:
  static WindowManifest manifest() {
    WindowManifest manifest;
    manifest.version = "1";
    manifest.options = {{"--window", "64"}};
    manifest.windows.resize(3);
    manifest.windows[0].name = "0000_0000";
    manifest.windows[1].name = "0000_0001";
    manifest.windows[2].name = "0001_0000";
    return manifest;
  }

  std::unique_ptr<WindowFolder> open(bool resume, const WindowManifest& what = manifest()) const {
    ModelWriterOptions options;
    options.anchor = {84000.0, 447000.0, 0.0};
    return std::make_unique<WindowFolder>(folder_.path("models"), what, options, resume);
  }

  static void add(WindowFolder* folder, size_t window, const std::string& id) {
    const Building building = sample_extrusion(id);
    folder->append(window, building, sample_model(building.origin));
  }

  /// All windows that are missing: two buildings, none, one.
  static void make(WindowFolder* folder) {
    if (!folder->is_done(0)) {
      add(folder, 0, "a");
      add(folder, 0, "b");
      folder->finish(0, {});
    }
    if (!folder->is_done(1)) {
      ManifestWindow counts;
      counts.small = 4;
      folder->finish(1, counts);
    }
    if (!folder->is_done(2)) {
      add(folder, 2, "c");
      folder->finish(2, {});
    }
  }

  /// The bytes of all files by name.
  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder_.path("models"))) {
      files[entry.path().filename().string()] = file_bytes(entry.path().string());
    }
    return files;
  }

  const ScratchFolder folder_;
};

TEST_F(WindowFolderTest, HoldsAFilePerWindowWithBuildings) {
  make(open(false).get());
  const auto made = files();
  EXPECT_EQ(made.size(), 3u);
  EXPECT_EQ(read_buildings(folder_.path("models/window_0000_0000.city.jsonl")).buildings.size(),
            2u);
  EXPECT_TRUE(made.contains("window_0001_0000.city.jsonl"));
  const WindowManifest manifest = read_manifest(folder_.path("models/manifest.json"));
  EXPECT_EQ(manifest.windows[0].buildings, (std::map<std::string, size_t>{{"extrusion", 2}}));
  EXPECT_EQ(manifest.windows[1].small, 4);
  EXPECT_EQ(manifest.windows[1].file, "");
}

TEST_F(WindowFolderTest, WhereverARunEndsTheNextOneGoesOnToTheSameBytes) {
  make(open(false).get());
  const auto undisturbed = files();
  for (size_t num_done = 0; num_done < 3; ++num_done) {
    for (const bool begun : {false, true}) {
      fs::remove_all(folder_.path("models"));
      {
        const auto folder = open(false);
        if (num_done > 0) {
          add(folder.get(), 0, "a");
          add(folder.get(), 0, "b");
          folder->finish(0, {});
        }
        if (num_done > 1) {
          ManifestWindow counts;
          counts.small = 4;
          folder->finish(1, counts);
        }
        if (begun) add(folder.get(), num_done == 0 ? 0 : 2, "lost");
      }
      const auto folder = open(true);
      EXPECT_EQ(folder->is_done(0), num_done > 0);
      make(folder.get());
      EXPECT_EQ(files(), undisturbed) << num_done << begun;
    }
  }
}

TEST_F(WindowFolderTest, WhatAKilledRunLeavesIsRemovedAndNothingElse) {
  make(open(false).get());
  folder_.write("models/window_0000_0000.city.jsonl.77-0.part", "half");
  folder_.write("models/manifest.json.77-0.part", "half");
  folder_.write("models/notes.part", "mine");
  open(true);
  const auto left = files();
  EXPECT_EQ(left.size(), 4u);
  EXPECT_TRUE(left.contains("notes.part"));
}

TEST_F(WindowFolderTest, AFileThatWasTamperedWithIsMadeAnew) {
  make(open(false).get());
  const auto undisturbed = files();
  folder_.write("models/window_0000_0000.city.jsonl", "tampered");
  fs::remove(folder_.path("models/window_0001_0000.city.jsonl"));
  const auto folder = open(true);
  EXPECT_FALSE(folder->is_done(0));
  EXPECT_TRUE(folder->is_done(1));
  EXPECT_FALSE(folder->is_done(2));
  make(folder.get());
  EXPECT_EQ(files(), undisturbed);
}

TEST_F(WindowFolderTest, ModelsAreNeitherOverwrittenNorMixed) {
  make(open(false).get());
  const Error again = error_of([&] { open(false); }, "--resume");
  EXPECT_EQ(again.code(), ExitCode::kUsage);
  WindowManifest other = manifest();
  other.options[0].second = "128";
  const Error mixed = error_of([&] { open(true, other); }, "manifest.json");
  EXPECT_EQ(mixed.code(), ExitCode::kUsage);
  EXPECT_THAT(mixed.what(), testing::HasSubstr("--window is \"128\", but was \"64\""));
}

TEST_F(WindowFolderTest, WhereNothingIsDoneThereIsNothingToLose) {
  open(false);
  WindowManifest other = manifest();
  other.options[0].second = "128";
  open(false, other);
  EXPECT_EQ(read_manifest(folder_.path("models/manifest.json")).options[0].second, "128");
}

TEST_F(WindowFolderTest, TwoRunsAtOnceAreRefused) {
  const auto first = open(false);
  EXPECT_EQ(error_of([&] { open(true); }, "another run").code(), ExitCode::kUsage);
}

TEST_F(WindowFolderTest, AFileInItsPlaceIsNamed) {
  folder_.write("models", "a file");
  EXPECT_EQ(error_of([&] { open(false); }, "models").code(), ExitCode::kCannotWrite);
}

}  // namespace
}  // namespace gable
