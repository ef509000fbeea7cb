#pragma once

#include <gable/grammar/solid/solid.h>

#include <string>

namespace gable {

/// When a solid counts as valid.
struct ValidityTolerance {
  double planarity = 1e-3;   ///< largest distance of a vertex from its face's plane, metres, > 0
  double resolution = 3e-3;  ///< least distance between vertices, and of a vertex from an edge that
                             ///< it does not end, metres, > 0
};

/// What is wrong with a solid (after ISO 19107): numbers of offending elements.
struct SolidValidity {
  int bad_rings = 0;        ///< under three vertices, or one vertex twice in a face
  int near_vertices = 0;    ///< pairs of vertices nearer than the resolution
  int near_edges = 0;       ///< vertices on or near an edge that they do not end: T-junctions
  int crossing_rings = 0;   ///< faces whose edges cross
  int misplaced_holes = 0;  ///< holes outside their face, inside another hole or not reversed
  int non_planar_faces = 0;
  int open_edges = 0;          ///< edges of one face only, or with faces of opposite orientation
  int non_manifold_edges = 0;  ///< edges of more than two faces
  int non_manifold_vertices = 0;
  int misfacing = 0;       ///< roofs that do not face up, grounds not down, walls not sideways
  int components = 0;      ///< connected parts of the boundary; 1 in a valid solid
  double planarity = 0.0;  ///< largest distance of a vertex from its face's plane, metres
  double volume = 0.0;     ///< cubic metres; positive when faces look outward

  bool valid() const;
  /// "valid", or the counts that are not as they should be.
  std::string describe() const;
};

/// Checks a solid. Faces must have vertex indices in range.
SolidValidity check_solid(const Solid& solid, const ValidityTolerance& tolerance = {});

}  // namespace gable
