#include <gable/grammar/solid/plane.h>

#include <cmath>

namespace gable {
namespace {

constexpr double kSamePlane = 1e-4;

}  // namespace

int PlaneSet::number_of(const Plane& plane) {
  for (size_t i = 0; i < planes_.size(); ++i) {
    const Plane difference = {plane.a - planes_[i].a, plane.b - planes_[i].b,
                              plane.c - planes_[i].c};
    // A linear function is largest at a corner.
    bool same = true;
    for (const double x : {low_.x(), high_.x()}) {
      for (const double y : {low_.y(), high_.y()}) {
        same = same && std::abs(difference.at({x, y})) < kSamePlane;
      }
    }
    if (same) return static_cast<int>(i);
  }
  planes_.push_back(plane);
  return static_cast<int>(planes_.size()) - 1;
}

}  // namespace gable
