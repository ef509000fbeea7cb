#pragma once

#include <gable/residuals/height_image.h>

#include <Eigen/Core>
#include <optional>

namespace gable {

/// A rectangle of the local frame turned anticlockwise by an azimuth about the local origin, metres
/// along the turned axes.
struct TurnedRectangle {
  double azimuth = 0.0;  ///< radians
  double x0 = 0.0, x1 = 0.0, y0 = 0.0, y1 = 0.0;
};

/// Heights over a component, metres above the local origin.
struct ComponentHeights {
  double eaves = 0.0;   ///< mean of the lowest tenth (NPR section 4.1)
  double middle = 0.0;  ///< median
  double top = 0.0;     ///< mean of the highest twentieth (NPR section 4.2)
};

/// Statistics of the heights of an image over a rectangle: of the measured pixels that lie in it
/// whole and stand at least `least_height` metres over the terrain. Heights are over the terrain,
/// raised by its median; single ones that stand out of or below those beside them count as these
/// (medians of 3 x 3 pixels). Nothing where there is no such pixel.
std::optional<ComponentHeights> component_heights(const HeightImage& image,
                                                  const TurnedRectangle& rectangle,
                                                  double least_height);

/// The median of the measured heights of the pixel at a local point and of those around it, metres
/// above the local origin. Nothing where none is measured, or beyond the image.
std::optional<double> height_near(const HeightImage& image, const Eigen::Vector2d& local);

}  // namespace gable
