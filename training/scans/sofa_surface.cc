#include <gable/grammar/random.h>
#include <gable/training/scans/sofa_shape.h>
#include <gable/training/scans/sofa_surface.h>
#include <gable/training/scans/surface_builder.h>
#include <gable/training/scans/surface_shapes.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Curve = std::vector<Vector2d>;

constexpr double kContact = 0.016;  // metres

/// Points of an arc about `center` from angle `from` to `to` (radians), `steps` chords.
void append_arc(Curve* curve, const Vector2d& center, double radius, double from, double to,
                int steps) {
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + (to - from) * i / steps;
    curve->push_back(center + radius * Vector2d(std::cos(angle), std::sin(angle)));
  }
}

class SofaBuilder {
 public:
  explicit SofaBuilder(const SofaShape& sofa) : s_(sofa) {
    seat_hull_ = builder_.add_hull();
    back_hull_ = builder_.add_hull();
    rear_hull_ = builder_.add_hull();
    seat_ = builder_.add_structure(seat_hull_);
    front_ = builder_.add_structure();
    back_ = builder_.add_structure(back_hull_);
    back_top_ = builder_.add_structure();
    rear_ = builder_.add_structure(rear_hull_);
    for (int side : {0, 1}) {
      outer_[side] = builder_.add_structure(builder_.add_hull());
    }
  }

  LabelledSurface build() {
    add_seat();
    add_back();
    add_base();
    for (bool right : {false, true}) add_side(right);
    add_legs();
    add_pillows();
    return builder_.build(kContact);
  }

 private:
  double inner_width() const { return s_.width - 2.0 * s_.arm_width; }

  /// Strips of a curve in y and z, swept along +x. Steep parts belong to `steep`, flat ones to
  /// `flat`, those between to what they touch.
  void sweep_x(const Curve& curve, double x, double length, int steep, int flat) {
    SurfaceBuilder::Ring points;
    for (const Vector2d& p : curve) points.push_back({x, p.x(), p.y()});
    std::vector<int> structure;
    for (size_t i = 0; i + 1 < curve.size(); ++i) {
      const Vector2d d = (curve[i + 1] - curve[i]).normalized();
      const double up = std::abs(d.y());
      structure.push_back(up > 0.8 ? steep : up < 0.6 ? flat : kTouching);
    }
    add_strips(&builder_, structure, points, {length, 0.0, 0.0});
  }

  /// The end of what sweep_x made of a curve, closed by its chord, looking to -x or +x.
  void cap_x(const Curve& curve, double x, bool right, int structure) {
    SurfaceBuilder::Ring ring;
    for (const Vector2d& p : curve) ring.push_back({x, p.x(), p.y()});
    if (!right) std::reverse(ring.begin(), ring.end());
    builder_.add_face(structure, ring);
  }

  void add_seat() {
    const double gap = 0.006, width = inner_width() / s_.seats;
    const double rear = s_.depth - s_.back_width - s_.lean;
    for (int i = 0; i < s_.seats; ++i) {
      const bool chaise = s_.chaise > 0.0 && i + 1 == s_.seats;
      const double front = chaise ? -s_.chaise : 0.0;
      const int front_plane = chaise ? builder_.add_structure() : front_;
      Curve curve = {{front, s_.base + 0.005}};
      append_arc(&curve, {front + s_.radius, s_.seat_height - s_.radius}, s_.radius, M_PI,
                 0.5 * M_PI, s_.steps);
      const double middle = 0.5 * (front + s_.radius + rear);
      curve.push_back({middle - 0.12, s_.seat_height + s_.bulge});
      curve.push_back({middle + 0.12, s_.seat_height + s_.bulge});
      curve.push_back({rear, s_.seat_height});
      const double x = s_.arm_width + i * width + 0.5 * gap;
      sweep_x(curve, x, width - gap, front_plane, seat_);
      if (chaise) add_chaise(x, width - gap, front_plane);
      curve.push_back({rear, s_.base});
      if (!s_.arms && i == 0) cap_x(curve, x, false, outer_[0]);
      if (!s_.arms && i + 1 == s_.seats) cap_x(curve, x + width - gap, true, outer_[1]);
    }
  }

  /// Base and sides of a seat that reaches forward.
  void add_chaise(double x, double width, int front) {
    const double y0 = -s_.chaise, high = s_.seat_height - 0.5 * s_.radius;
    const double x1 = x + width;
    builder_.add_face(front, {{x, y0 + 0.008, s_.leg},
                              {x1, y0 + 0.008, s_.leg},
                              {x1, y0 + 0.008, s_.base},
                              {x, y0 + 0.008, s_.base}});
    builder_.add_face(builder_.add_structure(),
                      {{x, 0.0, s_.leg}, {x, y0, s_.leg}, {x, y0, high}, {x, 0.0, high}});
    builder_.add_face(outer_[1],
                      {{x1, y0, s_.leg}, {x1, 0.0, s_.leg}, {x1, 0.0, high}, {x1, y0, high}});
  }

  /// Flat pillows that lean at the back's ends.
  void add_pillows() {
    const double y = s_.depth - s_.back_width - s_.lean - (s_.cushions_behind ? 0.08 : 0.02);
    const double side = 0.3, thick = 0.05;
    for (int i = 0; i < s_.pillows; ++i) {
      const double x = i == 0 ? s_.arm_width + 0.05 : s_.width - s_.arm_width - 0.05 - side;
      const double z = s_.seat_height + s_.bulge;
      add_box(&builder_, {x, y - thick, z}, {x + side, y, z + side}, kTouching, {kBottom, kBack});
    }
  }

  void add_back() {
    // The frame's outside: rear from the base up, round the top, down to the front.
    const double top = s_.back_height, rear = s_.depth;
    const double front = rear - s_.back_width;
    Curve curve;
    curve.push_back({front - s_.lean, s_.seat_height});
    append_arc(&curve, {front + s_.radius, top - s_.radius}, s_.radius, M_PI, 0.5 * M_PI, s_.steps);
    append_arc(&curve, {rear - s_.radius, top - s_.radius}, s_.radius, 0.5 * M_PI, 0.0, s_.steps);
    Curve front_side(curve.begin(), curve.begin() + s_.steps + 2);
    if (s_.cushions_behind) {
      // Cushions hide the frame's front, but for its ends over the arms.
      const Vector2d low = front_side[0], high = front_side[1];
      const double share = (s_.arm_height - low.y()) / (high.y() - low.y());
      const Curve over_arm = {low + share * (high - low), high};
      if (s_.arms) {
        for (double x : {0.0, s_.width - s_.arm_width}) {
          sweep_x(over_arm, x, s_.arm_width, back_, back_top_);
        }
      }
      front_side.erase(front_side.begin());
    }
    Curve rear_side(curve.begin() + s_.steps + 1, curve.end());
    rear_side.push_back({rear, s_.leg});
    sweep_x(front_side, 0.0, s_.width, back_, back_top_);
    sweep_x(rear_side, 0.0, s_.width, rear_, back_top_);
    frame_ = curve;
    frame_.push_back({rear, s_.leg});
    frame_.push_back({front - s_.lean, s_.leg});
    if (s_.cushions_behind) add_back_cushions(front);
  }

  void add_back_cushions(double frame_front) {
    const double gap = 0.006, width = inner_width() / s_.seats;
    const double low = s_.seat_height + 0.01, high = s_.back_height - s_.radius;
    const double thick = 0.05, lean = s_.lean;
    const auto at = [&](double share, double out) {
      return Vector2d(frame_front - lean * (1.0 - share) - out, low + share * (high - low));
    };
    const double round = 0.5 * s_.radius / (high - low);
    for (int i = 0; i < s_.seats; ++i) {
      const Curve curve = {at(0.0, 0.0),
                           at(0.02, thick),
                           at(0.3, thick + s_.bulge),
                           at(0.7, thick + s_.bulge),
                           at(1.0 - 2 * round, thick),
                           at(1.0, 0.5 * thick),
                           at(1.0, 0.0)};
      const double x = s_.arm_width + i * width + 0.5 * gap;
      SurfaceBuilder::Ring points;
      for (const Vector2d& p : curve) points.push_back({x, p.x(), p.y()});
      add_strips(&builder_, {kTouching, back_, back_, back_, kTouching, kTouching}, points,
                 {width - gap, 0.0, 0.0});
      if (i == 0) cap_x(curve, x, false, kTouching);
      if (i + 1 == s_.seats) cap_x(curve, x + width - gap, true, kTouching);
    }
  }

  void add_base() {
    // The front panel under the cushions, a little behind them.
    const double x0 = s_.arm_width, all = inner_width();
    const double x1 = x0 + (s_.chaise > 0.0 ? all - all / s_.seats : all);
    builder_.add_face(
        front_,
        {{x0, 0.008, s_.leg}, {x1, 0.008, s_.leg}, {x1, 0.008, s_.base}, {x0, 0.008, s_.base}});
  }

  void add_side(bool right) {
    const Eigen::Affine3d before = builder_.pose();
    if (right) {
      Eigen::Affine3d mirror = Eigen::Affine3d::Identity();
      mirror.linear()(0, 0) = -1.0;
      mirror.translation().x() = s_.width;
      builder_.set_pose(mirror);
    }
    const int outer = outer_[right];
    // The end of the back's frame.
    SurfaceBuilder::Ring end;
    for (const Vector2d& p : frame_) end.insert(end.begin(), {0.0, p.x(), p.y()});
    builder_.add_face(outer, end);
    if (s_.arms) {
      const int inner = builder_.add_structure(), top = builder_.add_structure();
      const int face = builder_.add_structure();
      const double r = std::min(s_.radius * 1.2, 0.45 * s_.arm_width), w = s_.arm_width;
      // Across the arm, in x and z, from outside over the top to the inside.
      Curve curve = {{0.0, s_.leg}};
      if (s_.rolled) {
        const double roll = 0.5 * w + 0.025;
        append_arc(&curve, {0.5 * w, s_.arm_height - roll}, roll, 1.2 * M_PI, -0.2 * M_PI,
                   3 * s_.steps);
      } else {
        append_arc(&curve, {r, s_.arm_height - r}, r, M_PI, 0.5 * M_PI, s_.steps);
        append_arc(&curve, {w - r, s_.arm_height - r}, r, 0.5 * M_PI, 0.0, s_.steps);
      }
      curve.push_back({w, s_.seat_height - 0.05});
      const double front = 0.0, rear = s_.depth - s_.back_width;
      SurfaceBuilder::Ring points, cap;
      for (const Vector2d& p : curve) {
        points.push_back({p.x(), rear, p.y()});
        cap.insert(cap.begin(), {p.x(), front, p.y()});
      }
      std::vector<int> structure;
      for (size_t i = 0; i + 1 < curve.size(); ++i) {
        const Vector2d d = (curve[i + 1] - curve[i]).normalized();
        const int steep = d.y() > 0.0 ? outer : inner;
        structure.push_back(std::abs(d.y()) > 0.8   ? steep
                            : std::abs(d.y()) < 0.6 ? top
                                                    : kTouching);
      }
      add_strips(&builder_, structure, points, {0.0, front - rear, 0.0});
      cap.push_back({w, front, s_.leg});
      cap.insert(cap.begin(), cap.back());
      cap.pop_back();
      builder_.add_face(face, cap);
    } else {
      builder_.add_face(outer, {{0.0, s_.depth - s_.back_width, s_.leg},
                                {0.0, 0.008, s_.leg},
                                {0.0, 0.008, s_.base},
                                {0.0, s_.depth - s_.back_width, s_.base}});
    }
    builder_.set_pose(before);
  }

  void add_legs() {
    const double side = 0.05, front = s_.arms ? 0.0 : 0.008;
    for (double x : {0.0, s_.width - side}) {
      for (double y : {front, s_.depth - side}) {
        add_box(&builder_, {x, y, 0.0}, {x + side, y + side, s_.leg}, kTouching, {kTop, kBottom});
      }
    }
  }

  SofaShape s_;
  SurfaceBuilder builder_;
  Curve frame_;
  int seat_hull_, back_hull_, rear_hull_;
  int seat_, front_, back_, back_top_, rear_;
  int outer_[2];  // left, right
};

}  // namespace

LabelledSurface random_sofa(uint64_t seed) {
  Random random(seed);
  return SofaBuilder(random_sofa_shape(&random)).build();
}

}  // namespace gable
