#include <gable/engine/error.h>
#include <gable/engine/reconstruct/report/report_writer.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <thread>

#include "engine/reconstruct/report/report_sample.h"

namespace gable {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

size_t num_files(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

class ReportWriterTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::path(::testing::TempDir()) /
            (std::string("gable_report_") + test->name() + std::to_string(getpid()));
    fs::remove_all(root_);
    fs::create_directories(root_);
  }
  void TearDown() override { fs::remove_all(root_); }

  fs::path root_;
};

TEST_F(ReportWriterTest, WritesAPageAndOnePicturePerBuilding) {
  const fs::path folder = root_ / "new" / "report";
  const Building house = house_with_all_parts("way/12 <b>&'\"");
  const Building other = courtyard_building("courtyard");
  {
    ReportWriter writer(folder.string());
    writer.add(1, other, image_of(other, 48, 0.5, 0.05, 2));
    writer.add(0, house, image_of(house, 64, 0.5, 0.05, 1));
    writer.finish();
  }
  const std::string page = read(folder / "index.html");
  EXPECT_THAT(page, HasSubstr("way/12 &lt;b&gt;&amp;&#39;&quot;"));
  EXPECT_THAT(page, Not(HasSubstr("<b>&'")));
  EXPECT_LT(page.find("way/12"), page.find("courtyard"));
  EXPECT_THAT(page, HasSubstr(other.reason));
  for (const char* name : {"houses/000000-way_12__b____.png", "houses/000001-courtyard.png"}) {
    EXPECT_THAT(page, HasSubstr("src=\"" + std::string(name) + "\""));
    const cv::Mat picture = cv::imread((folder / name).string());
    EXPECT_EQ(picture.size(), cv::Size(1360, 426)) << name;
  }
  EXPECT_EQ(num_files(folder), 2u);
  EXPECT_EQ(num_files(folder / "houses"), 2u);
}

TEST_F(ReportWriterTest, SameBytesWhateverTheOrderOfTheThreads) {
  constexpr int kHouses = 6;
  const auto write = [](const fs::path& folder, int num_threads) {
    ReportWriter writer(folder.string(), {.panel_size = 64});
    std::vector<std::thread> threads;
    for (int t = 0; t < num_threads; ++t) {
      threads.emplace_back([&writer, t, num_threads] {
        for (int i = kHouses - 1 - t; i >= 0; i -= num_threads) {
          const Building house = house_with_all_parts("house " + std::to_string(i));
          writer.add(i, house, image_of(house, 40, 0.5, 0.1, i));
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    writer.finish();
  };
  write(root_ / "one", 1);
  write(root_ / "three", 3);
  size_t compared = 0;
  for (const auto& entry : fs::recursive_directory_iterator(root_ / "one")) {
    if (!entry.is_regular_file()) continue;
    EXPECT_EQ(read(entry.path()),
              read(root_ / "three" / fs::relative(entry.path(), root_ / "one")));
    ++compared;
  }
  EXPECT_EQ(compared, kHouses + 1u);
}

TEST_F(ReportWriterTest, LeavesNothingWithoutFinish) {
  std::ofstream(root_ / "mine.txt") << "kept";
  {
    ReportWriter writer((root_ / "deep" / "report").string());
    const Building house = house_with_all_parts("a");
    writer.add(0, house, image_of(house, 40, 0.5, 0.1, 1));
  }
  EXPECT_EQ(num_files(root_), 1u);
  { ReportWriter writer(root_.string()); }
  EXPECT_EQ(num_files(root_), 1u);
  EXPECT_EQ(read(root_ / "mine.txt"), "kept");
}

TEST_F(ReportWriterTest, ReplacesAnEarlierReport) {
  for (const double mad : {0.11, 0.22}) {
    ReportWriter writer(root_.string(), {.panel_size = 64});
    Building house = house_with_all_parts("a");
    house.quality.mad = mad;
    writer.add(0, house, image_of(house, 40, 0.5, 0.1, 1));
    writer.finish();
  }
  const std::string page = read(root_ / "index.html");
  EXPECT_THAT(page, HasSubstr("0.22"));
  EXPECT_THAT(page, Not(HasSubstr("0.11")));
  EXPECT_EQ(num_files(root_ / "houses"), 1u);
}

TEST_F(ReportWriterTest, NamesAFolderThatCannotBeMade) {
  const fs::path file = root_ / "file";
  std::ofstream(file) << "no folder";
  for (const fs::path& folder : {file, file / "report"}) {
    try {
      const ReportWriter writer(folder.string());
      FAIL() << folder;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::kCannotWrite);
      EXPECT_THAT(error.what(), HasSubstr(folder.string()));
    }
  }
  EXPECT_EQ(num_files(root_), 1u);
}

TEST(PictureName, IsSafeAndDifferentForEveryIndex) {
  EXPECT_EQ(picture_name(7, "NL.IMBAG.Pand.1"), "000007-NL.IMBAG.Pand.1.png");
  EXPECT_EQ(picture_name(8, "../a b"), "000008-.._a_b.png");
  EXPECT_LE(picture_name(9, std::string(5000, 'x')).size(), 80u);
}

TEST(ReportOptions, CheckNamesTheViolatedBound) {
  EXPECT_EQ(check(ReportOptions{}), "");
  EXPECT_THAT(check(ReportOptions{.panel_size = 63}), HasSubstr("panel_size"));
  EXPECT_THAT(check(ReportOptions{.residual_range = 0.0}), HasSubstr("residual_range"));
}

}  // namespace
}  // namespace gable
