#include <gable/engine/io/footprint_writer.h>
#include <gable/grammar/plan_outline.h>

#include "engine/io/scratch.h"

namespace gable {
namespace {

std::vector<Footprint> two_footprints() {
  Footprint square{"a", {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}}};
  Footprint ring = square;
  ring.id = "b";
  ring.polygon.holes = {{{2, 2}, {2, 8}, {8, 8}, {8, 2}}};
  return {square, ring};
}

TEST(FootprintWriter, TheSameFootprintsGiveTheSameBytes) {
  const ScratchFolder folder;
  const Crs crs = crs_from_text("EPSG:27700");
  write_footprints(folder.path("a.gpkg"), two_footprints(), crs);
  write_footprints(folder.path("b.gpkg"), two_footprints(), crs);
  const std::string bytes = file_bytes(folder.path("a.gpkg"));
  EXPECT_EQ(bytes.substr(0, 15), "SQLite format 3");
  EXPECT_EQ(bytes, file_bytes(folder.path("b.gpkg")));
  EXPECT_EQ(folder.num_files(), 2);
}

TEST(FootprintWriter, AFolderThatDoesNotExistIsNamed) {
  const ScratchFolder folder;
  const std::string path = folder.path("none/footprints.gpkg");
  const Error error = error_of(
      [&] { write_footprints(path, two_footprints(), crs_from_text("EPSG:27700")); }, path);
  EXPECT_EQ(error.code(), ExitCode::kCannotWrite);
}

}  // namespace
}  // namespace gable
