#include <gable/engine/io/scans/las_reader.h>

#include <limits>

#include "engine/io/scans/expect_scan.h"
#include "engine/io/scans/sample_files.h"

namespace gable {
namespace {

Scan classified() {
  Scan scan = sample_cloud();
  scan.labels = {{"class", {0, 1, 0, 2, 7}}};
  scan.normals.clear();
  return scan;
}

std::string with_number(std::string bytes, size_t at, auto value) {
  std::string raw;
  append_bytes(value, &raw);
  return bytes.replace(at, raw.size(), raw);
}

TEST(Las, GivesThePointsOfEveryFormat) {
  for (int minor = 0; minor <= 4; ++minor) {
    for (int format = 0; format <= (minor < 4 ? 5 : 10); ++format) {
      SCOPED_TRACE("1." + std::to_string(minor) + " format " + std::to_string(format));
      expect_scan(read_las(las_file(sample_cloud(), minor, format), "scan").scan, classified());
    }
  }
}

TEST(Las, RefusesWhatIsNone) {
  const std::string file = las_file(sample_cloud(), 2, 3);
  expect_refused(read_las, "", "does not start with LASF");
  expect_refused(read_las, "LASX" + file.substr(4), "does not start with LASF");
  expect_refused(read_las, file.substr(0, 200), "ends within its header");
  expect_refused(read_las, las_file(sample_cloud(), 4, 6).substr(0, 300), "within its header");
  expect_refused(read_las, file.substr(0, file.size() - 1), "announces 5 points, but holds 4");
  expect_refused(read_las, with_number(file, 107, uint32_t{4000000000}), "announces 4000000000");
  expect_refused(read_las, with_number(file, 107, uint32_t{0}), "holds no points");
  expect_refused(read_las, with_number(file, 96, uint32_t{4000000000}), "but holds 0");
  expect_refused(read_las, with_number(file, 104, uint8_t{3 | 128}), "compressed (LAZ)");
  expect_refused(read_las, with_number(file, 104, uint8_t{11}), "unknown point format 11");
  expect_refused(read_las, with_number(file, 105, uint16_t{20}), "20 bytes, too few");
  expect_refused(read_las, with_number(file, 131, 0.0), "scale");
  expect_refused(read_las, with_number(file, 155, std::numeric_limits<double>::quiet_NaN()),
                 "scale or offset");
  expect_refused(read_las, with_number(las_file(sample_cloud(), 4, 6), 247, uint64_t{1} << 63),
                 "announces");
}

TEST(Las, IsSafeWhereverTheFileEnds) {
  expect_prefixes_are_safe(read_las, las_file(sample_cloud(), 4, 10));
}

}  // namespace
}  // namespace gable
