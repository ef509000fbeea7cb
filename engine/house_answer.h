#pragma once

#include <gable/engine/annotated_house.h>
#include <gable/engine/detectors/crop_rectangle.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace gable {

/// Where the pixels of a crop lie in the world: those of `HouseCrop`, x along the direction
/// `azimuth`, y a quarter turn clockwise from it, (0, 0) the outer corner of the first pixel.
struct CropFrame {
  double azimuth = 0.0;  ///< radians, from east anticlockwise to crop x
  Eigen::Vector2d north_west = Eigen::Vector2d::Zero();  ///< world point of crop (0, 0), metres
  double pixel = 0.5;                                    ///< metres

  Eigen::Vector2d world_from_crop(const Eigen::Vector2d& crop) const;
  Eigen::Vector2d crop_from_world(const Eigen::Vector2d& world) const;
};

/// One building of an editable list: what a program proposes and somebody corrects, in crop pixels.
struct HouseAnswer {
  std::string id;
  std::string sheet;  ///< file name of the contact sheet that shows it
  CropFrame frame;
  std::string proposed;  ///< name of the foundation as proposed, not to be edited
  Foundation foundation = Foundation::kC;
  std::vector<CropRectangle> rectangles;  ///< of I, II, III
  std::vector<Eigen::Vector2d> polygon;   ///< of L, U, C; otherwise empty: around the rectangles
  std::vector<RoofType> roofs;
  std::vector<Eigen::Vector2d> dormers;
  std::vector<Eigen::Vector2d> chimneys;
  std::vector<std::vector<Eigen::Vector2d>> garages;
  std::optional<Confidence> confidence;
  bool reviewed = false;
};

/// The files that buildings were looked at in; paths below the folder of the data (GABLE_DATA).
struct AnnotationSource {
  std::string tile;        ///< the surface
  std::string dtm;         ///< empty: the terrain was derived
  std::string footprints;  ///< empty: buildings were found in the heights
  std::string crs;         ///< "EPSG:27700"; empty where the raster's has no code
  double gsd = 1.0;        ///< of the surface, metres
};

/// The list, and what it belongs to.
struct HouseAnswers {
  AnnotationSource source;
  std::vector<HouseAnswer> houses;
};

/// The annotated buildings of a raster.
struct AnnotatedTile {
  AnnotationSource source;
  std::vector<AnnotatedHouse> houses;
};

}  // namespace gable
