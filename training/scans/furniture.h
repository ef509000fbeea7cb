#pragma once

#include <gable/grammar/random.h>
#include <gable/training/scans/surface_builder.h>

#include <Eigen/Core>

namespace gable {

/// Pieces of furniture, each in a frame of its own (the builder's pose places it): it stands on
/// z = 0 over the rectangle (0, 0) to (size.x, size.y), its back along y = size.y, its front at
/// y = 0; size.z is its height. Metres.
///
/// Planes: the main faces are of the structure; the rest (legs, drawers, handles) belongs to what
/// it touches. A large piece is one plane of the hull, the others belong to what they touch.
void add_table(SurfaceBuilder* builder, const Eigen::Vector3d& size, bool large, Random* random);
/// A table with a screen at its back and a block of drawers under one end.
void add_desk(SurfaceBuilder* builder, const Eigen::Vector3d& size, bool large, Random* random);
void add_chair(SurfaceBuilder* builder, const Eigen::Vector3d& size, Random* random);
void add_cupboard(SurfaceBuilder* builder, const Eigen::Vector3d& size, bool large, Random* random);
void add_bed(SurfaceBuilder* builder, const Eigen::Vector3d& size, bool large, Random* random);
void add_bookshelf(SurfaceBuilder* builder, const Eigen::Vector3d& size, bool large,
                   Random* random);
/// A couch of simple boxes, for rooms.
void add_couch(SurfaceBuilder* builder, const Eigen::Vector3d& size, bool large, Random* random);

}  // namespace gable
