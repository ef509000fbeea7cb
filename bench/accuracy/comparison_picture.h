#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/residuals/height_image.h>

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace gable {

/// One of the two models of a row, and what is written over it.
struct ComparedModel {
  std::string name;
  Building building;
};

/// Two models of one building.
struct ComparedPair {
  std::string id;
  HeightImage image;
  ComparedModel without, with;
};

/// One row a pair: measured heights, model without, difference, model with, difference (measured
/// less model, metres). All of a row are in the same colours, north up, cut to the building and 2 m
/// around it. 8-bit BGR, `panel_size` pixels a panel.
cv::Mat draw_comparison(const std::string& title, const std::vector<ComparedPair>& pairs,
                        int panel_size);

}  // namespace gable
