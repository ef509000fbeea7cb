#include <gable/engine/io/scans/scan_file.h>

#include "engine/io/scans/expect_scan.h"
#include "engine/io/scans/sample_files.h"

namespace gable {
namespace {

TEST(ScanFile, ReadsEveryFormatByItsExtension) {
  const ScratchFolder scratch;
  const Scan cloud = sample_cloud(), mesh = sample_mesh();
  const std::pair<const char*, std::string> files[] = {
      {"a.ply", ply_file(cloud, "ascii")}, {"a.PLY", ply_file(mesh, "binary_big_endian")},
      {"a.xyz", xyz_file(cloud, true)},    {"a.XyzN", xyz_file(cloud, true)},
      {"a.txt", xyz_file(cloud, false)},   {"a.pwn", pwn_file(cloud)},
      {"a.off", off_file(mesh)},           {"a.obj", obj_file(mesh)},
      {"a.las", las_file(cloud, 2, 1)},    {"a.b.pcd", pcd_file(cloud, "binary")},
  };
  for (const auto& [name, bytes] : files) {
    EXPECT_EQ(read_scan(scratch.write(name, bytes)).points, cloud.points) << name;
  }
}

TEST(ScanFile, NamesTheKnownExtensions) {
  const ScratchFolder scratch;
  for (const char* name : {"scan.doc", "scan", ".ply"}) {
    const std::string path = scratch.write(name, "1 2 3\n");
    const Error error = error_of([&] { read_scan(path); }, path);
    EXPECT_EQ(error.code(), ExitCode::kBadInput);
    for (const char* known :
         {".ply", ".xyzn", ".pwn", ".off", ".obj", ".las", ".laz", ".pcd", ".tif"}) {
      EXPECT_THAT(error.what(), testing::HasSubstr(known));
    }
  }
}

TEST(ScanFile, RefusesWhatIsNotThere) {
  const ScratchFolder scratch;
  for (const char* name : {"none.ply", "none.tif", "none.las", "none.doc", "."}) {
    const std::string path = scratch.path(name);
    EXPECT_EQ(error_of([&] { read_scan(path); }, path).code(), ExitCode::kNoInput) << name;
  }
}

TEST(ScanFile, RefusesEmptyFiles) {
  const ScratchFolder scratch;
  for (const char* name : {"a.ply", "a.xyz", "a.xyzn", "a.txt", "a.pwn", "a.off", "a.obj", "a.las",
                           "a.laz", "a.pcd", "a.tif", "a.asc"}) {
    const std::string path = scratch.write(name, "");
    EXPECT_EQ(error_of([&] { read_scan(path); }, path).code(), ExitCode::kBadInput) << name;
  }
}

TEST(ScanFile, RefusesDamagedLazFiles) {
  const ScratchFolder scratch;
  const std::string path = scratch.write("a.laz", las_file(sample_cloud(), 2, 1).substr(0, 230));
  EXPECT_EQ(error_of([&] { read_scan(path); }, path).code(), ExitCode::kBadInput);
}

TEST(ScanFile, MakesPointsOfTheCellsOfAHeightRaster) {
  const ScratchFolder scratch;
  const std::string path = scratch.write("a.asc",
                                         "ncols 3\nnrows 2\nxllcorner 1000\nyllcorner 2000\n"
                                         "cellsize 2\nNODATA_value -9999\n"
                                         "1 2 -9999\n4 5.5 6\n");
  const Scan scan = read_scan(path, {.raster_crs = "EPSG:27700"});
  const std::vector<Eigen::Vector3d> want = {
      {1001, 2003, 1}, {1003, 2003, 2}, {1001, 2001, 4}, {1003, 2001, 5.5}, {1005, 2001, 6}};
  EXPECT_EQ(scan.points, want);
  EXPECT_FALSE(scan.is_mesh());
}

}  // namespace
}  // namespace gable
