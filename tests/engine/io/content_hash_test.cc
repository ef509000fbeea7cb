#include <gable/engine/io/content_hash.h>

#include "engine/io/scratch.h"

namespace gable {
namespace {

std::string hash_of(std::string_view bytes) {
  ContentHash hash;
  hash.add(bytes);
  return hash.text();
}

TEST(ContentHash, GivesTheKnownValues) {
  EXPECT_EQ(hash_of(""), "cbf29ce484222325");
  EXPECT_EQ(hash_of("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(hash_of("foobar"), "85944171f73967e8");
}

TEST(ContentHash, AFileHasTheHashOfItsBytes) {
  const ScratchFolder folder;
  std::string bytes(200000, '\0');
  for (size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * i % 251);
  EXPECT_EQ(hash_of_file(folder.write("f", bytes)), hash_of(bytes));
  EXPECT_EQ(error_of([&] { hash_of_file(folder.path("none")); }, "none").code(),
            ExitCode::kNoInput);
}

TEST(FileIdentity, IsOfTheSizeAndBothEnds) {
  const ScratchFolder folder;
  const std::string bytes(300000, 'x');
  const FileIdentity before = identity_of_file(folder.write("f", bytes));
  EXPECT_EQ(before.bytes, bytes.size());
  std::string changed = bytes;
  changed.back() = 'y';
  EXPECT_NE(identity_of_file(folder.write("f", changed)).hash, before.hash);
  changed = bytes;
  changed.front() = 'y';
  EXPECT_NE(identity_of_file(folder.write("f", changed)).hash, before.hash);
  EXPECT_EQ(identity_of_file(folder.write("f", "ab")).hash, hash_of("ab"));
}

}  // namespace
}  // namespace gable
