#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/residuals/height_image.h>

#include <array>
#include <opencv2/core.hpp>
#include <string>

namespace gable {

/// How the picture of a house is drawn.
struct HousePictureOptions {
  int panel_size = 320;         ///< pixels, [64, 2048]
  double residual_range = 1.0;  ///< residual of the strongest colours, metres, (0, 100]
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const HousePictureOptions& options);

/// The picture of one house: four views side by side, north up.
struct HousePicture {
  cv::Mat image;                   ///< 8-bit BGR
  std::array<cv::Rect, 4> panels;  ///< measured heights, model, residual, parts; where in the image
};

/// Draws the measured heights, the model's heights in the same colours, the residual (measured less
/// model, metres, blue to red) and the outline with its semantic parts. The size of the picture
/// follows from the options alone.
HousePicture draw_house_picture(const Building& building, const HeightImage& image,
                                const HousePictureOptions& options);

/// "gable, hip": the roofs of a house by component.
std::string roof_list(const House& house);

}  // namespace gable
