#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/residuals/height_image.h>

#include <cstdint>
#include <string>

namespace gable {

/// An L-shaped house with a hip and a gable roof, a dormer, a chimney and a garage, turned by 20
/// degrees. Its origin is far from the world's.
Building house_with_all_parts(const std::string& id);

/// A building outside the grammar: a square of 12 m with a courtyard of 4 m, 6 m high.
Building courtyard_building(const std::string& id);

/// An image of `cells` x `cells` cells of `gsd` metres centred on the building: its own heights
/// over sloping ground plus normal noise of `sigma` metres.
HeightImage image_of(const Building& building, int cells, double gsd, double sigma, uint64_t seed);

}  // namespace gable
