#include <gable/engine/io/atomic_file.h>

#include "engine/io/scratch.h"

namespace gable {
namespace {

TEST(AtomicFile, AppearsOnlyAtCommit) {
  const ScratchFolder scratch;
  const std::string path = scratch.write("out.txt", "old");
  {
    AtomicFile file(path);
    file.write("new ");
    file.write("text");
    EXPECT_EQ(file_bytes(path), "old");
    file.commit();
  }
  EXPECT_EQ(file_bytes(path), "new text");
  EXPECT_EQ(scratch.num_files(), 1);
}

TEST(AtomicFile, LeavesNothingWithoutCommit) {
  const ScratchFolder scratch;
  {
    AtomicFile file(scratch.path("out.txt"));
    file.write(std::string(3 << 20, 'x'));
    EXPECT_EQ(scratch.num_files(), 1);
  }
  EXPECT_EQ(scratch.num_files(), 0);
}

TEST(AtomicFile, MissingFolderIsOneLineAtOpening) {
  const ScratchFolder scratch;
  const std::string path = scratch.path("no/such/out.txt");
  const Error error = error_of([&] { AtomicFile file(path); }, path);
  EXPECT_EQ(error.code(), ExitCode::kCannotWrite);
  EXPECT_THAT(error.what(), testing::HasSubstr("No such file or directory"));
}

TEST(AtomicFile, FolderOfThatNameIsRefused) {
  const ScratchFolder scratch;
  std::filesystem::create_directories(scratch.path("out"));
  EXPECT_EQ(error_of([&] { AtomicFile file(scratch.path("out")); }).code(), ExitCode::kCannotWrite);
}

TEST(AtomicFile, FullDiskIsAnErrorAndTheDeviceStays) {
  if (!std::filesystem::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const Error error = error_of([] { write_file_atomically("/dev/full", "text"); }, "/dev/full");
  EXPECT_EQ(error.code(), ExitCode::kCannotWrite);
  EXPECT_THAT(error.what(), testing::HasSubstr("No space left on device"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(AtomicFile, FollowsALink) {
  const ScratchFolder scratch;
  const std::string target = scratch.write("target.txt", "old");
  std::filesystem::create_symlink("target.txt", scratch.path("link.txt"));
  write_file_atomically(scratch.path("link.txt"), "new");
  EXPECT_EQ(file_bytes(target), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(scratch.path("link.txt")));
}

}  // namespace
}  // namespace gable
