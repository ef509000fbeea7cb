// From a surface and a terrain raster to a file of house models.
#include <gable/engine/error.h>
#include <gable/engine/io/models/model_writer.h>
#include <gable/engine/io/raster/raster_file.h>
#include <gable/engine/reconstruct/building/reconstruct_building.h>
#include <gable/engine/reconstruct/tile/tile_crops.h>
#include <gable/grammar/synthesis/village.h>

#include <cstdio>

using namespace gable;

/// Two rasters of one grid to house models; `writer` may be null.
void reconstruct(const HeightRaster& dsm, const HeightRaster& dtm, ModelWriter* writer) {
  const FoundHouses found = find_houses(dsm, dtm, {});
  for (size_t i = 0; i < found.houses.size(); ++i) {
    const HeightImage image = crop_found_house(dsm, dtm, found, i, {});
    const ReconstructedBuilding made =
        reconstruct_building("house_" + std::to_string(i), image, nullptr, {});
    const Building& building = made.building;
    std::printf("%s: %s, %.2f m from the heights\n", building.id.c_str(),
                building_status_name(building.status), building.quality.mad);
    if (writer) writer->append(building, made.model);
  }
  if (writer) writer->close();
}

/// usage: 07_reconstruct_a_raster [DSM DTM OUT.city.json]
int main(int argc, char** argv) try {
  if (argc < 4) {
    const Village village = synthesize_village({.count = 2, .seed = 7});
    reconstruct(village.dsm, village.dtm, nullptr);
    return 0;
  }
  const RasterFile dsm(argv[1]), dtm(argv[2]);
  require_matching(dsm, dtm);
  ModelWriterOptions options;
  options.crs = dsm.crs();
  options.anchor.head<2>() = dsm.grid().center_of(0, 0);
  reconstruct(dsm.read(), dtm.read_onto(dsm.grid()), open_model_writer(argv[3], options).get());
  return 0;
} catch (const Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return static_cast<int>(error.code());
}
