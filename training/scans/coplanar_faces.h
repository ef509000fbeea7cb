#pragma once

#include <gable/grammar/solid/solid.h>

#include <vector>

namespace gable {

/// When touching faces count as one plane. With an angle of 90 degrees the offset alone decides, so
/// that the risers of small steps are taken in and what they join is one plane.
struct CoplanarTolerance {
  double angle_deg = 1.0;  ///< between outward normals
  double offset = 0.02;    ///< of every corner from the plane of the largest face, metres
};

/// The number of the plane of every face, from 0 in the order of the planes' lowest faces. Planes
/// grow from the largest face without one over faces that share a vertex; the largest face's plane
/// is what all others are compared with, so that a bent row of faces does not drift into one.
std::vector<int> coplanar_faces(const Solid& solid, const CoplanarTolerance& tolerance = {});

}  // namespace gable
