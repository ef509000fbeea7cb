#pragma once

#include <gable/grammar/block.h>

#include <Eigen/Core>
#include <array>
#include <span>

namespace gable {

/// By how much, metres, blocks reach beyond their rectangles, their roofs' planes continued, to
/// fill a known outline: a point that no block covers belongs to those that cover it with the first
/// of these margins that any reaches it with. So every block gives way to all others where they
/// are. How many of them are used is the house's: an outline may hold yards where nothing stands.
inline constexpr std::array<double, 3> kOutlineMargins = {0.0, 0.5, 1.5};

/// Whether a block's rectangle, enlarged by `margin` metres on every side, holds a point of the
/// house frame. Of blocks with a common edge one holds each point on it.
bool reaches(const Block<double>& block, double margin, const Eigen::Vector2d& point);

/// Height of a block's roof with its planes continued beyond the rectangle, at any point of the
/// house frame: inside, `roof_height`.
double continued_roof_height(const Block<double>& block, const Eigen::Vector2d& point);

/// The first margin, of those up to `most` metres, with which one of the blocks that stand on the
/// ground reaches a point of the house frame, or -1 where none does.
double outline_margin_at(std::span<const Block<double>> ground_blocks, double most,
                         const Eigen::Vector2d& point);

}  // namespace gable
