#include <gable/engine/io/scans/scan_file.h>
#include <gable/engine/io/shapes/labelled_ply.h>

#include "engine/io/scans/expect_scan.h"
#include "engine/io/scans/sample_files.h"

namespace gable {
namespace {

TEST(LabelledPly, GivesTheScanBackWithItsShapes) {
  const ScratchFolder scratch;
  for (Scan scan : {sample_cloud(), sample_mesh()}) {
    for (const bool normals : {true, false}) {
      if (!normals) scan.normals.clear();
      scan.points[4] = {4500123.123456789, -0.1, 1e-300};  // exact to the last bit
      std::vector<int> shape_of(scan.num_elements(), -1);
      shape_of[1] = 12345678;
      const std::string path = scratch.path("shapes.ply");
      write_labelled_ply(path, scan, shape_of);
      Scan want = scan;
      want.labels = {{"shape", shape_of}};
      expect_scan(read_scan(path), want);
    }
  }
}

TEST(LabelledPly, GivesAScanBackWithItsOwnLabels) {
  const ScratchFolder scratch;
  for (Scan scan : {sample_cloud(), sample_mesh()}) {
    const int n = static_cast<int>(scan.num_elements());
    for (int i = 0; i < n; ++i) {
      scan.labels["scale_1"].push_back(i - 1);
      scan.labels["scale_2"].push_back(7 * (n - i));
    }
    const std::string path = scratch.path("scan.ply");
    write_scan_ply(path, scan);
    expect_scan(read_scan(path), scan);
  }
}

TEST(LabelledPly, SaysWhereItCannotWrite) {
  const std::string path = "/no/such/folder/shapes.ply";
  const std::vector<int> shape_of(5, -1);
  const Error error = error_of([&] { write_labelled_ply(path, sample_cloud(), shape_of); }, path);
  EXPECT_EQ(error.code(), ExitCode::kCannotWrite);
}

}  // namespace
}  // namespace gable
