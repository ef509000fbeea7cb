#pragma once

#include <gable/engine/reconstruct/report/building_surface.h>
#include <gable/residuals/height_image.h>

#include <opencv2/core.hpp>
#include <vector>

namespace gable {

/// How the cells of an image lie on the square panel of a picture: enlarged by a whole number where
/// they fit, so that every cell is one square of pixels; otherwise reduced to the panel's size.
struct PanelScale {
  PanelScale(const HeightImage& image, int panel_size);

  double pixels_per_cell = 1.0;
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels

  /// The cell under a pixel.
  int row_of(int y, const HeightImage& image) const;
  int col_of(int x, const HeightImage& image) const;
};

/// Model heights at the image's cells (metres above image.origin.z()), rows x cols, each averaged
/// over its cell.
std::vector<float> model_heights(const BuildingSurface& surface, const HeightImage& image);

/// Whether a cell holds a measurement.
bool is_measured(const HeightImage& image, size_t index);

/// A range of heights in metres.
struct HeightRange {
  double low = 0.0;
  double high = 1.0;
};

/// The range that both the measured and the model heights are shown in: without the highest and
/// lowest half percent of the measurements, but with all of the model.
HeightRange shown_range(const HeightImage& image, const std::vector<float>& model);

/// Heights as colours, shaded by a light from the north-west. Cells that `image` has no measurement
/// for are grey where `measured_only`.
cv::Mat height_panel(const HeightImage& image, const std::vector<float>& heights,
                     const HeightRange& range, bool measured_only, const PanelScale& scale);

/// Measured less model height as colours, `range` metres being the strongest.
cv::Mat residual_panel(const HeightImage& image, const std::vector<float>& model, double range,
                       const PanelScale& scale);

/// How bright a cell of a surface is under a light from the north-west, in [0, 1]; cells beside one
/// that is not finite are lit as if level.
double shade(const HeightImage& image, const std::vector<float>& heights, int row, int col);

}  // namespace gable
