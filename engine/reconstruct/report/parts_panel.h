#pragma once

#include <gable/engine/drawing/color.h>
#include <gable/engine/reconstruct/report/building_surface.h>
#include <gable/engine/reconstruct/report/height_panels.h>
#include <gable/residuals/height_image.h>

#include <opencv2/core.hpp>

namespace gable {

/// Colours of the semantic parts. Components take turns with `kComponentColors`.
inline constexpr Color kComponentColors[] = {{214, 190, 150}, {196, 168, 134}, {178, 150, 122}};
inline constexpr Color kGarageColor{126, 148, 172};
inline constexpr Color kDormerColor{112, 160, 138};
inline constexpr Color kChimneyColor{158, 76, 64};

Color part_color(BlockRole role, int index);

/// What is seen from above: the parts in their colours, outlined, with the ridges and hips that are
/// in sight, over a pale picture of the measured heights.
cv::Mat parts_panel(const BuildingSurface& surface, const HeightImage& image,
                    const PanelScale& scale);

}  // namespace gable
