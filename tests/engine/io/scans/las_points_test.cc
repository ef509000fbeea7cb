#include <gable/engine/io/scans/las_points.h>

#include "engine/io/scans/sample_files.h"
#include "engine/io/scratch.h"

namespace gable {
namespace {

/// A LAS file with one variable length record.
std::string with_record(const std::string& file, int id, const std::string& data) {
  constexpr size_t kHeader = 227;
  std::string record(54, '\0');
  record.replace(2, 15, "LASF_Projection");
  const auto put = [](auto value, size_t at, std::string* bytes) {
    std::string raw;
    append_bytes(value, &raw);
    bytes->replace(at, raw.size(), raw);
  };
  put(static_cast<uint16_t>(id), 18, &record);
  put(static_cast<uint16_t>(data.size()), 20, &record);
  record += data;
  std::string bytes = file.substr(0, kHeader) + record + file.substr(kHeader + 5);
  put(static_cast<uint32_t>(kHeader + record.size()), 96, &bytes);
  put(uint32_t{1}, 100, &bytes);
  return bytes;
}

std::string geo_keys(const std::vector<int>& words) {
  std::string bytes;
  for (const int word : words) append_bytes(static_cast<uint16_t>(word), &bytes);
  return bytes;
}

TEST(LasPoints, AreThoseOfTheFileInEveryFormat) {
  const ScratchFolder folder;
  const Scan scan = sample_cloud();
  for (int format = 0; format <= 10; ++format) {
    const std::string path = folder.write("a.las", las_file(scan, format < 6 ? 2 : 4, format));
    size_t count = 0;
    visit_las_points(path, [&](const LasPoint& point) {
      ASSERT_LT(count, scan.points.size());
      EXPECT_EQ(point.position, scan.points[count]);
      EXPECT_EQ(point.classification, std::max(0, scan.labels.at("plane")[count]));
      EXPECT_FALSE(point.withheld);
      ++count;
    });
    EXPECT_EQ(count, scan.points.size());
  }
}

TEST(LasPoints, SayWhetherTheyAreWithheld) {
  const ScratchFolder folder;
  for (const int format : {1, 7}) {
    std::string file = las_file(sample_cloud(), format < 6 ? 2 : 4, format);
    const size_t first = (format < 6 ? 227 : 375) + 5;
    file[first + 15] = static_cast<char>(file[first + 15] | (format < 6 ? 128 : 4));
    std::vector<bool> withheld;
    visit_las_points(folder.write("a.las", file),
                     [&](const LasPoint& point) { withheld.push_back(point.withheld); });
    EXPECT_EQ(withheld, (std::vector<bool>{true, false, false, false, false}));
  }
}

TEST(LasPoints, ManyPiecesAreOneFile) {
  const ScratchFolder folder;
  Scan scan;
  for (int i = 0; i < 100000; ++i) scan.points.emplace_back(0.25 * i, 1.0, 2.0);
  scan.labels["plane"].assign(scan.points.size(), 2);
  int count = 0;
  visit_las_points(folder.write("a.las", las_file(scan, 2, 0)),
                   [&](const LasPoint& point) { EXPECT_EQ(point.position.x(), 0.25 * count++); });
  EXPECT_EQ(count, 100000);
}

TEST(LasPoints, DamagedFilesAreNamed) {
  const ScratchFolder folder;
  const std::string file = las_file(sample_cloud(), 2, 3);
  const auto code = [&](const std::string& name, const std::string& bytes) {
    const std::string path = folder.write(name, bytes);
    return error_of([&] { visit_las_points(path, [](const LasPoint&) {}); }, path).code();
  };
  EXPECT_EQ(code("short.las", file.substr(0, file.size() - 1)), ExitCode::kBadInput);
  EXPECT_EQ(code("text.las", "text"), ExitCode::kBadInput);
  EXPECT_EQ(code("empty.las", ""), ExitCode::kBadInput);
  const std::string none = folder.path("none.las");
  EXPECT_EQ(error_of([&] { visit_las_points(none, [](const LasPoint&) {}); }, none).code(),
            ExitCode::kNoInput);
}

TEST(LasCrs, IsReadFromKeysAndFromWkt) {
  const ScratchFolder folder;
  const std::string file = las_file(sample_cloud(), 2, 1);
  const auto crs = [&](const std::string& bytes) {
    return read_las_crs(folder.write("a.las", bytes));
  };
  EXPECT_TRUE(crs(file).empty());
  EXPECT_EQ(
      crs(with_record(file, 34735, geo_keys({1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, 28992}))).epsg,
      28992);
  EXPECT_TRUE(crs(with_record(file, 34735, geo_keys({1, 1, 0, 1, 3072, 0, 1, 32767}))).empty());
  EXPECT_EQ(crs(with_record(file, 2112, crs_from_text("EPSG:27700").wkt + '\0')).epsg, 27700);
}

TEST(LasCrs, ANameThatIsNoneIsRefused) {
  const ScratchFolder folder;
  const std::string file = las_file(sample_cloud(), 2, 1);
  for (const std::string text : {"EPSG:28992", "/etc/passwd", "PROJCS["}) {
    const std::string path = folder.write("a.las", with_record(file, 2112, text));
    EXPECT_EQ(error_of([&] { read_las_crs(path); }, path).code(), ExitCode::kBadInput) << text;
  }
}

TEST(LasCrs, IsSafeWhereverTheFileEnds) {
  const ScratchFolder folder;
  const std::string file =
      with_record(las_file(sample_cloud(), 2, 1), 34735, geo_keys({1, 1, 0, 1, 3072, 0, 1, 28992}));
  for (size_t size = 227; size < file.size(); ++size) {
    EXPECT_NO_FATAL_FAILURE(read_las_crs(folder.write("a.las", file.substr(0, size)))) << size;
  }
}

}  // namespace
}  // namespace gable
