#pragma once

#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/models/globe_position.h>
#include <gable/engine/io/models/model_writer.h>

#include <string>

namespace gable {

/// KML 2.2 for globe viewers, or the same zipped (.kmz, which holds doc.kml): a Folder per
/// building, and in it a Placemark per kind and brightness of surface with the finest solids' faces
/// as polygons and the attributes (`table_attributes`) as ExtendedData. Viewers do not shade
/// polygons, so faces are coloured by how they lie to a light from the south-west. Convex faces are
/// polygons as they are; others are cut into triangles, which every viewer fills the same way.
///
/// Longitude and latitude on WGS 84, degrees. Altitudes are the heights of the raster in metres
/// (altitudeMode absolute): viewers take them for heights above sea level (EGM96), which those of
/// national datums are within a metre or so, ellipsoidal ones not. With kml_on_terrain they are
/// heights above the building's terrain (relativeToGround); every point is then lifted by the
/// viewer's terrain under it, which bends buildings on slopes.
class KmlWriter : public ModelWriter {
 public:
  /// Throws Error: kUsage without a reference system, kCannotWrite.
  KmlWriter(const std::string& path, const ModelWriterOptions& options);
  void append(const Building& building, const BuildingModel& model) override;
  void close() override;

 private:
  void write(const std::string& text);

  AtomicFile file_;
  GlobePosition position_;
  bool on_terrain_, zipped_;
  std::string text_;  ///< what is to be zipped
};

}  // namespace gable
