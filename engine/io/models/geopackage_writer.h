#pragma once

#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/models/model_writer.h>

#include <memory>

namespace gable {

/// GeoPackage with two layers, in the reference system of the buildings; read by GIS programs.
///
/// `buildings`: MultiPolygon, the plan of each building (the union of its ground faces), with `id`
/// and what `table_attributes` lists, under the same names; and the derivation as JSON. Lists are
/// text with commas.
///
/// `roofs`: MultiPolygon Z, each plane of each part's roof, less what dormers, chimneys and the
/// like cover of it, with `building`, `part` ("main-1", "garage-1", ...), `area_m2` along the
/// slope, `plan_area_m2`, `slope_deg` (from level) and `aspect_deg` (the way down, clockwise from
/// grid north, null where the slope is under half a degree). Heights are those of the raster.
///
/// Both show LoD 2.2, or the finest there is, without roof slabs. Kept in memory until close.
class GeoPackageWriter : public ModelWriter {
 public:
  /// Throws Error (kCannotWrite).
  GeoPackageWriter(const std::string& path, const ModelWriterOptions& options);
  ~GeoPackageWriter() override;
  void append(const Building& building, const BuildingModel& model) override;
  void close() override;

 private:
  struct Rows;

  AtomicFile file_;
  Crs crs_;
  std::unique_ptr<Rows> rows_;
};

}  // namespace gable
