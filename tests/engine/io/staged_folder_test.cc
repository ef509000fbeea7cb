#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/staged_folder.h>
#include <gtest/gtest.h>

#include "engine/io/scratch.h"

namespace gable {
namespace {

namespace fs = std::filesystem;

TEST(StagedFolder, ShowsFilesOnlyWhenAllAreComplete) {
  const ScratchFolder scratch;
  const std::string folder = scratch.path("a/b");
  {
    StagedFolder staged(folder);
    write_file_atomically(staged.path("one.txt"), "1");
    write_file_atomically(staged.path("two.txt"), "2");
    EXPECT_FALSE(fs::exists(folder + "/one.txt"));
    staged.commit();
    EXPECT_EQ(file_bytes(folder + "/one.txt"), "1");
    EXPECT_EQ(file_bytes(folder + "/two.txt"), "2");
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);
}

TEST(StagedFolder, LeavesNothingWithoutCommit) {
  const ScratchFolder scratch;
  {
    const StagedFolder staged(scratch.path("a/b"));
    write_file_atomically(staged.path("one.txt"), "1");
  }
  EXPECT_EQ(scratch.num_files(), 0);
}

TEST(StagedFolder, ReplacesFilesOfTheSameNameAndKeepsOthers) {
  const ScratchFolder scratch;
  scratch.write("one.txt", "old");
  scratch.write("other.txt", "other");
  {
    StagedFolder staged(scratch.path(""));
    write_file_atomically(staged.path("one.txt"), "new");
    EXPECT_EQ(file_bytes(scratch.path("one.txt")), "old");
    staged.commit();
  }
  EXPECT_EQ(file_bytes(scratch.path("one.txt")), "new");
  EXPECT_EQ(file_bytes(scratch.path("other.txt")), "other");
  EXPECT_EQ(scratch.num_files(), 2);
}

TEST(StagedFolder, TwoMayShareAFolder) {
  const ScratchFolder scratch;
  {
    StagedFolder a(scratch.path("both"));
    StagedFolder b(scratch.path("both"));
    write_file_atomically(a.path("a.txt"), "a");
    write_file_atomically(b.path("b.txt"), "b");
    a.commit();
    b.commit();
  }
  EXPECT_EQ(file_bytes(scratch.path("both/a.txt")), "a");
  EXPECT_EQ(file_bytes(scratch.path("both/b.txt")), "b");
}

TEST(StagedFolder, AFolderThatCannotBeMadeIsRefused) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("file", "a file, no folder");
  for (const std::string& folder : {file, file + "/below"}) {
    EXPECT_EQ(error_of([&] { StagedFolder{folder}; }, folder).code(), ExitCode::kCannotWrite);
  }
  EXPECT_EQ(scratch.num_files(), 1);
}

}  // namespace
}  // namespace gable
