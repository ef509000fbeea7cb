#include <gable/engine/io/models/build_model.h>
#include <gable/engine/io/models/building_plan.h>
#include <gable/engine/ordered_pool.h>
#include <gable/engine/reconstruct/building/refine_building.h>
#include <gable/engine/reconstruct/heights/fill.h>
#include <gable/engine/reconstruct/tile/refine_models.h>
#include <gable/engine/reconstruct/tile/tile_spread.h>
#include <gable/engine/reconstruct/tile/tile_windows.h>
#include <gable/grammar/polygon_cells.h>
#include <glog/logging.h>

#include <Eigen/Geometry>
#include <utility>

namespace gable {
namespace {

struct Outline {
  Eigen::Vector2d origin;
  std::vector<PlanPolygon> polygons;  ///< relative to origin
  CellBox cells;                      ///< around them
};

Outline outline_of(const Building& building, const Grid& grid) {
  Outline outline;
  outline.origin = origin_of(building).head<2>();
  outline.polygons = plan_of(building);
  Eigen::AlignedBox2d extent(outline.origin);
  for (const PlanPolygon& polygon : outline.polygons) {
    for (const Eigen::Vector2d& p : polygon.outer) extent.extend(outline.origin + p);
  }
  outline.cells = cells_around(extent.min(), extent.max(), grid);
  return outline;
}

bool overlap(const CellBox& a, const CellBox& b) {
  return a.row0 < b.row1 && b.row0 < a.row1 && a.col0 < b.col1 && b.col0 < a.col1;
}

void mark(const Outline& outline, CellRole role, const Grid& grid, std::vector<CellRole>* roles) {
  for (const PlanPolygon& polygon : outline.polygons) {
    for_cells_in_polygon(polygon, outline.origin, grid, [&](int row, int col) {
      (*roles)[static_cast<size_t>(row) * grid.cols + col] = role;
    });
  }
}

void mark_crowns(const HeightRaster& dsm, const HeightRaster& dtm, const VegetationOptions& options,
                 std::vector<CellRole>* roles) {
  HeightImage image;
  image.gsd = dsm.grid.gsd;
  image.rows = dsm.grid.rows;
  image.cols = dsm.grid.cols;
  image.height = dsm.values;
  image.ground = dtm.values;
  const std::vector<unsigned char> crown =
      find_vegetation(image, vegetation_at(options, image.gsd));
  for (size_t i = 0; i < roles->size(); ++i) {
    CellRole& role = (*roles)[i];
    if (crown[i]) role = role == CellRole::kBuilding ? CellRole::kCovered : CellRole::kCrown;
  }
}

HeightImage crop_model(const RasterFile& dsm_file, const RasterFile& dtm_file,
                       const std::vector<Building>& buildings, const std::vector<Outline>& outlines,
                       size_t index, const HeightCropOptions& crop,
                       const VegetationOptions& vegetation) {
  const CellBox box = with_margin(outlines[index].cells, crop.margin, dsm_file.grid());
  const HeightRaster dsm =
      dsm_file.read(box.row0, box.col0, box.row1 - box.row0, box.col1 - box.col0);
  const HeightRaster dtm = fill_smoothly(dtm_file.read_onto(dsm.grid));
  std::vector<CellRole> roles(dsm.grid.size(), CellRole::kOpen);
  for (size_t i = 0; i < outlines.size(); ++i) {
    if (i != index && overlap(outlines[i].cells, box)) {
      mark(outlines[i], CellRole::kNeighbour, dsm.grid, &roles);
    }
  }
  mark(outlines[index], CellRole::kBuilding, dsm.grid, &roles);
  mark_crowns(dsm, dtm, vegetation, &roles);
  HeightImage image =
      crop_heights(dsm, dtm, {0, 0, dsm.grid.rows, dsm.grid.cols}, roles, false, crop);
  const Building& building = buildings[index];
  move_origin(building.house ? building.house->origin : building.origin, &image);
  return image;
}

}  // namespace

std::string check(const RefineModelsOptions& options) {
  if (const std::string error = check(options.refinement); !error.empty()) return error;
  if (const std::string error = check(options.crop); !error.empty()) return error;
  if (options.threads < 1 || options.threads > 1024) return "threads must lie in [1, 1024]";
  return "";
}

bool refine_models(const RasterFile& dsm, const RasterFile& dtm,
                   const std::vector<Building>& buildings, const RefineModelsOptions& options,
                   const std::stop_token& stop, const TileCallbacks& callbacks) {
  CHECK(check(options).empty()) << check(options);
  HeightCropOptions crop = options.crop;
  if (!crop.spread) crop.spread = tile_spread(dsm);
  std::vector<Outline> outlines;
  for (const Building& building : buildings) {
    outlines.push_back(outline_of(building, dsm.grid()));
  }
  if (callbacks.begin_window) callbacks.begin_window(0, 1, buildings.size());
  return run_in_order<TileBuilding>(
      buildings.size(), options.threads, stop,
      [&](size_t i) {
        TileBuilding out;
        out.index = i;
        out.image = crop_model(dsm, dtm, buildings, outlines, i, crop, options.vegetation);
        if (buildings[i].house) {
          ReconstructedBuilding refined =
              refine_building(buildings[i], options.refinement, &out.image);
          out.building = std::move(refined.building);
          out.model = std::move(refined.model);
        } else {
          out.building = buildings[i];
          out.model = build_model(buildings[i]);
        }
        if (callbacks.inspect) callbacks.inspect(out);
        return out;
      },
      [&](TileBuilding&& out) {
        if (callbacks.deliver) callbacks.deliver(std::move(out));
      });
}

}  // namespace gable
