#pragma once

#include <gable/engine/annotated_house.h>
#include <gable/engine/reconstruct/tile/reconstruct_tile.h>
#include <gable/residuals/height_image.h>

#include <cstddef>
#include <stop_token>
#include <vector>

namespace gable {

/// The heights of an annotated building as reconstruction cuts them.
struct AnnotatedImage {
  size_t house = 0;  ///< index of the annotation
  HeightImage image;
};

/// Intersection over union of an image's inside pixels and an annotation, its garages with it.
double annotation_iou(const HeightImage& image, const AnnotatedHouse& house);

/// Finds the annotated buildings of a tile: each annotation goes to the building of the tile that
/// it shares most with, where that is at least `least_iou`; buildings that are not found, or parts
/// of something else, have no entry. In the order of the annotations.
std::vector<AnnotatedImage> annotated_images(const TileInput& input, const TileOptions& options,
                                             const std::vector<AnnotatedHouse>& houses,
                                             double least_iou, const std::stop_token& stop);

}  // namespace gable
