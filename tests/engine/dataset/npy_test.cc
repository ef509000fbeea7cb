#include <gable/engine/dataset/npy.h>
#include <gtest/gtest.h>

#include <cstring>

namespace gable {
namespace {

TEST(Npy, TheHeaderIsTheFormatsOwnAndEndsOnAMultipleOf64) {
  for (size_t n : {size_t{1}, size_t{7}, size_t{123456789}}) {
    const std::string header = npy_header("<f4", {n, 3});
    EXPECT_EQ(header.substr(0, 6), "\x93NUMPY");
    EXPECT_EQ(header.size() % 64, 0u);
    EXPECT_EQ(header.back(), '\n');
    const size_t length =
        static_cast<unsigned char>(header[8]) + 256u * static_cast<unsigned char>(header[9]);
    EXPECT_EQ(length + 10, header.size());
    EXPECT_NE(header.find("'shape': (" + std::to_string(n) + ", 3, )"), std::string::npos);
  }
}

TEST(Npy, OneDimensionKeepsItsComma) {
  EXPECT_NE(npy_header("|u1", {5}).find("(5, )"), std::string::npos);
}

TEST(Npy, ValuesFollowTheHeaderAsTheyAre) {
  const std::vector<float> values = {1.5f, -2.0f, 3.25f};
  const std::string file = npy_file(values, {3});
  const std::string header = npy_header("<f4", {3});
  ASSERT_EQ(file.size(), header.size() + 12);
  float last = 0.0f;
  std::memcpy(&last, file.data() + header.size() + 8, 4);
  EXPECT_EQ(last, 3.25f);
}

}  // namespace
}  // namespace gable
