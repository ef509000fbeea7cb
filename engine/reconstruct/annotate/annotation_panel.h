#pragma once

#include <gable/engine/house_answer.h>
#include <gable/grammar/raster.h>
#include <gable/residuals/height_image.h>

#include <functional>
#include <opencv2/core.hpp>
#include <string>

namespace gable {

/// The cells of a raster that a panel of a frame shows, with a cell more around.
Grid grid_around(const CropFrame& frame, const Grid& raster);

/// What is drawn of one building.
struct AnnotationPanelInput {
  const HouseAnswer* answer = nullptr;
  const HeightRaster* dsm = nullptr;   ///< at least the cells of `grid_around`
  double datum = 0.0;                  ///< height of the terrain, metres
  const HeightImage* image = nullptr;  ///< whose inside pixels are outlined; may be null
  std::string title;
};

/// Size of the two panels of a building with their frames, pixels.
cv::Size annotation_panel_size();

/// A building twice, side by side, turned by the azimuth of its frame, six pixels to one of the
/// crop: heights over the datum in colours, shaded by a light from the top left, with contour lines
/// and the answer's outline, rectangles, dormers, chimneys and garages; and the directions of the
/// normals (red to the right, green to the top, blue up) with the outline of the inside pixels.
/// Along the frame stand the crop's pixels; small crosses mark every eighth. 8-bit BGR.
cv::Mat draw_annotation_panel(const AnnotationPanelInput& input);

/// The level of the terrain where nothing is known of it: a low percentile of the heights in a
/// frame, metres.
double low_height(const HeightRaster& dsm, const CropFrame& frame);

}  // namespace gable
