#include <gable/training/scans/coplanar_faces.h>
#include <gable/training/scans/face_plane.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gable {
namespace {

bool lies_in(const FacePlane& plane, const Solid& solid, const Face& face,
             const FacePlane& face_own_plane, const CoplanarTolerance& tolerance) {
  // Less a rounding error, so that 90 degrees takes in faces at right angles.
  const double least_cosine = std::cos(tolerance.angle_deg * M_PI / 180.0) - 1e-9;
  if (plane.normal.dot(face_own_plane.normal) < least_cosine) return false;
  for (const std::vector<int>& ring : face.rings) {
    for (const int corner : ring) {
      if (std::abs(plane.distance(solid.vertices[corner])) > tolerance.offset) return false;
    }
  }
  return true;
}

/// Numbers from 0 in the order in which they first occur.
void renumber(std::vector<int>* numbers) {
  std::vector<int> new_number(numbers->size(), -1);
  int next = 0;
  for (int& number : *numbers) {
    if (new_number[number] < 0) new_number[number] = next++;
    number = new_number[number];
  }
}

}  // namespace

std::vector<int> coplanar_faces(const Solid& solid, const CoplanarTolerance& tolerance) {
  const int n = static_cast<int>(solid.faces.size());
  std::vector<FacePlane> planes;
  std::vector<std::vector<int>> faces_at(solid.vertices.size());
  for (int i = 0; i < n; ++i) {
    planes.push_back(face_plane(solid, solid.faces[i]));
    for (const std::vector<int>& ring : solid.faces[i].rings) {
      for (const int corner : ring) faces_at[corner].push_back(i);
    }
  }
  std::vector<int> by_area(n);
  std::iota(by_area.begin(), by_area.end(), 0);
  std::stable_sort(by_area.begin(), by_area.end(),
                   [&](int a, int b) { return planes[a].area > planes[b].area; });
  std::vector<int> plane_of(n, -1);
  for (const int seed : by_area) {
    if (plane_of[seed] >= 0) continue;
    plane_of[seed] = seed;
    std::vector<int> waiting = {seed};
    while (!waiting.empty()) {
      const int face = waiting.back();
      waiting.pop_back();
      for (const std::vector<int>& ring : solid.faces[face].rings) {
        for (const int corner : ring) {
          for (const int other : faces_at[corner]) {
            if (plane_of[other] >= 0 ||
                !lies_in(planes[seed], solid, solid.faces[other], planes[other], tolerance)) {
              continue;
            }
            plane_of[other] = seed;
            waiting.push_back(other);
          }
        }
      }
    }
  }
  renumber(&plane_of);
  return plane_of;
}

}  // namespace gable
