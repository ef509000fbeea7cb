#include <gable/grammar/random.h>
#include <gable/training/scans/car_shape.h>
#include <gable/training/scans/car_side.h>
#include <gable/training/scans/car_surface.h>
#include <gable/training/scans/surface_builder.h>
#include <gable/training/scans/surface_shapes.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kContact = 0.012;  // metres

class CarBuilder {
 public:
  CarBuilder(const CarShape& car, Random* random) : c_(car), random_(random) {}

  LabelledSurface build() {
    add_body();
    for (bool left : {false, true}) add_car_side(c_, left, &builder_);
    if (c_.underbody) {
      const double half = c_.half_width() - 0.05;
      builder_.add_face(builder_.add_structure(builder_.add_hull()),
                        {{0.05, -half, c_.sill},
                         {0.05, half, c_.sill},
                         {c_.length - 0.05, half, c_.sill},
                         {c_.length - 0.05, -half, c_.sill}});
    }
    return builder_.build(kContact);
  }

 private:
  static double arch(double t) { return 4.0 * t * (1.0 - t); }

  /// A panel across the car between two cross lines (x, half width, z), curved both ways: `rise`
  /// moves its middle up, `out` bows its lines in plan (towards -x if positive).
  void add_cross_panel(int structure, const Vector3d& from, const Vector3d& to, double crown,
                       double bulge, double bow_from, double bow_to, int along) {
    const Vector3d d = to - from;
    const Vector3d normal = Vector3d(-d.z(), 0.0, d.x()).normalized();
    add_patch(&builder_, structure, c_.strips, along, [&](double s, double t) -> Vector3d {
      const Vector3d line = from + t * d;
      // Seen from above with the car's rear up, -y is to the right.
      const double y = (1.0 - 2.0 * s) * line.y();
      const double bow = bow_from + t * (bow_to - bow_from);
      Vector3d at(line.x() - bow * arch(s), y, line.z());
      // Straight where the sides are, so that the panels meet them.
      return at + arch(s) * (crown + bulge * arch(t)) * normal;
    });
  }

  void add_body() {
    const int front_hull = builder_.add_hull(), bonnet_hull = builder_.add_hull();
    const int roof_hull = builder_.add_hull(), rear_hull = builder_.add_hull();
    const int back_hull = c_.boot ? builder_.add_hull() : rear_hull;
    const double half = c_.half_width(), end = half - c_.taper;
    const int front = builder_.add_structure(front_hull);
    const int bonnet = builder_.add_structure(bonnet_hull);
    const int windscreen = builder_.add_structure(bonnet_hull);
    const int roof = builder_.add_structure(roof_hull);
    const int rear_window = builder_.add_structure(back_hull);
    const int rear = builder_.add_structure(rear_hull);

    add_end(front, c_.nose, 0.0, 1.0, end);
    add_cross_panel(bonnet, {0.0, end, c_.nose}, {c_.bonnet_end, half, c_.belt}, c_.crown, c_.bulge,
                    c_.bow, 0.0, c_.strips);
    add_cross_panel(windscreen, {c_.bonnet_end, c_.half_belt(), c_.belt + 0.01},
                    {c_.roof_start, c_.half_roof(), c_.roof}, 0.5 * c_.crown, 0.3 * c_.bulge, 0.0,
                    0.0, 2);
    add_cross_panel(roof, {c_.roof_start, c_.half_roof(), c_.roof},
                    {c_.roof_end, c_.half_roof(), c_.roof}, c_.crown, c_.bulge, 0.0, 0.0,
                    c_.strips);
    add_cross_panel(rear_window, {c_.roof_end, c_.half_roof(), c_.roof},
                    {c_.rear_window_end, c_.half_belt(), c_.boot_height}, 0.5 * c_.crown,
                    0.3 * c_.bulge, 0.0, 0.0, 2);
    if (c_.boot) {
      const int boot = builder_.add_structure(back_hull);
      add_cross_panel(boot, {c_.rear_window_end, half, c_.boot_height},
                      {c_.length, end, c_.boot_height - 0.03}, 0.5 * c_.crown, 0.5 * c_.bulge, 0.0,
                      -c_.bow, 2);
    }
    if (!c_.boot) {  // the ledge from the rear window to the rear
      add_cross_panel(kTouching, {c_.rear_window_end, c_.half_belt(), c_.boot_height},
                      {c_.length, end, c_.boot_height}, 0.0, 0.0, 0.0, -c_.bow, 1);
    }
    add_end(rear, c_.boot ? c_.boot_height - 0.03 : c_.boot_height, c_.length, -1.0, end);
  }

  /// Front or rear: strips up from the lower edge, the bumper standing out, lights and plate.
  /// @param out  the end looks to -x if 1, to +x if -1
  void add_end(int structure, double top, double x, double out, double half) {
    const double low = c_.sill, height = top - low;
    const double levels[] = {
        low, low + 0.25 * height, low + 0.28 * height, low + 0.55 * height, low + 0.58 * height,
        top};
    const double offsets[] = {0.0, 0.0, c_.bumper, c_.bumper, 0.0, 0.0};
    for (int k = 0; k + 1 < 6; ++k) {
      add_patch(&builder_, structure, c_.strips, 1, [&](double s, double t) -> Vector3d {
        const double y = out * (2.0 * s - 1.0) * -half;
        const double offset = offsets[k] + t * (offsets[k + 1] - offsets[k]);
        return {x - out * (offset + c_.bow * arch(s)), y,
                levels[k] + t * (levels[k + 1] - levels[k])};
      });
    }
    // The bumper's ends.
    for (double side : {-1.0, 1.0}) {
      SurfaceBuilder::Ring ring;
      for (int k = 1; k < 5; ++k) ring.push_back({x - out * offsets[k], side * half, levels[k]});
      if (side * out < 0.0) std::reverse(ring.begin(), ring.end());
      builder_.add_face(structure, ring);
    }
    // Lights between bumper and bonnet, a plate on the bumper.
    const double z0 = levels[4] + 0.03, z1 = std::min(top - 0.03, z0 + 0.14);
    const double wide = random_->uniform(0.22, 0.34);
    const double at = x - out * c_.bow * arch(0.5 * (0.04 + wide) / half);
    for (double side : {-1.0, 1.0}) {
      const double y0 = side * (half - 0.04), y1 = side * (half - 0.04 - wide);
      add_box(&builder_, {at - 0.03, std::min(y0, y1), z0}, {at + 0.03, std::max(y0, y1), z1},
              structure, {out > 0.0 ? kRight : kLeft});
    }
    const double plate = x - out * (c_.bow + c_.bumper);
    add_box(&builder_, {plate - 0.012, -0.26, levels[2] + 0.02},
            {plate + 0.012, 0.26, levels[2] + 0.13}, structure, {out > 0.0 ? kRight : kLeft});
  }

  CarShape c_;
  Random* random_;
  SurfaceBuilder builder_;
};

}  // namespace

LabelledSurface random_car(uint64_t seed) {
  Random random(seed);
  const CarShape shape = random_car_shape(&random);
  return CarBuilder(shape, &random).build();
}

}  // namespace gable
