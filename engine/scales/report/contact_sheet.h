#pragma once

#include <gable/engine/scales/scale_labels.h>
#include <gable/engine/scales/trajectory.h>
#include <gable/engine/scan.h>

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace gable {

/// How a contact sheet is laid out, and which part of the trajectory it shows.
struct ContactSheetOptions {
  int columns = 6;              ///< [1, 64]
  int rows = 4;                 ///< [1, 64]
  int thumbnail_width = 300;    ///< pixels, [64, 2048]
  int thumbnail_height = 225;   ///< pixels, [64, 2048]
  int first_configuration = 0;  ///< >= 0
  int last_configuration = -1;  ///< -1: the trajectory's last
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const ContactSheetOptions& options);

/// The configurations on a sheet, rising: at most columns x rows of them, about even in the
/// logarithm of the number of shapes, denser at the coarse end, and the beginnings of all scales
/// that `labels` has in this part of the trajectory.
std::vector<int> sheet_configurations(const Trajectory& trajectory, const ScaleLabels& labels,
                                      const ContactSheetOptions& options);

/// Pictures of the configurations of a trajectory, for a person to write down at which one each
/// scale begins: elements coloured by shape (a colour stays with the larger part through merges),
/// each captioned with its number and its number of shapes, underlined in the colour of its label.
/// Where a scale of `labels` begins, the picture is framed and says so; labels without scales
/// (`first` empty) mark nothing. `first_shapes` are those of the scan. 8-bit BGR.
cv::Mat draw_contact_sheet(const Scan& scan, const FirstShapes& first_shapes,
                           const Trajectory& trajectory, const ScaleLabels& labels,
                           const std::string& title, const ContactSheetOptions& options = {});

}  // namespace gable
