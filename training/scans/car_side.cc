#include <gable/training/scans/car_side.h>
#include <gable/training/scans/surface_shapes.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The right side, towards -y; a mirroring pose makes the left one of it.
class CarSide {
 public:
  CarSide(const CarShape& car, SurfaceBuilder* builder) : c_(car), builder_(builder) {}

  void add() {
    const int hull = builder_->add_hull();
    const int body = builder_->add_structure(hull), windows = builder_->add_structure(hull);
    add_body_side(body);
    add_windows(windows);
    for (double axle : {c_.front_axle, c_.rear_axle}) add_wheel(body, axle);
    add_mirror();
  }

 private:
  /// The body: straight in the middle with both arches, tapered at the ends.
  void add_body_side(int structure) {
    const double y = -c_.half_width(), end = y + c_.taper, l = c_.length;
    const double front = std::min(c_.corner, c_.front_axle - c_.wheel - 0.12);
    const double rear = std::min(c_.corner, l - c_.rear_axle - c_.wheel - 0.12);
    const double lean = 0.015;  // of the part over the crease
    const double boot = c_.boot ? c_.boot_height : c_.belt;
    // Lower part with arches, in x and z.
    std::vector<Vector2d> outline = {{front, c_.sill}};
    for (double axle : {c_.front_axle, c_.rear_axle}) {
      const std::vector<Vector2d> arch_points = arch_of(axle);
      outline.insert(outline.end(), arch_points.begin(), arch_points.end());
    }
    outline.push_back({l - rear, c_.sill});
    outline.push_back({l - rear, c_.crease});
    outline.push_back({front, c_.crease});
    const double handle = 0.5 * (c_.bonnet_end + c_.roof_end);
    std::vector<Inset> insets;
    if (c_.sill + 0.24 < c_.crease - 0.1) {
      const double z = 0.5 * (c_.sill + c_.crease);
      const double x0 = c_.front_axle + c_.wheel + 0.15, x1 = c_.rear_axle - c_.wheel - 0.15;
      insets.push_back({{{x0, z}, {x1, z}, {x1, z + 0.06}, {x0, z + 0.06}}, -0.02});
    }
    add_panel(builder_, structure, {0.0, y, 0.0}, Vector3d::UnitX(), Vector3d::UnitZ(), outline,
              insets);
    const auto at = [&](double x, double z) {
      return Vector3d(x, y + lean * (z - c_.crease) / (c_.belt - c_.crease), z);
    };
    const double top = y + lean;
    builder_->add_face(structure, {at(front, c_.crease), at(l - rear, c_.crease),
                                   at(l - rear, boot), at(c_.rear_window_end * 0.98, c_.belt),
                                   at(c_.bonnet_end, c_.belt), at(front, c_.nose + 0.02)});
    // The tapered ends.
    const Vector3d nose(0.0, end, c_.nose), tail(l, end, boot - 0.02);
    builder_->add_face(
        structure,
        {{0.0, end, c_.sill}, {front, y, c_.sill}, {front, y, c_.crease}, {0.0, end, c_.crease}});
    builder_->add_face(structure, {{0.0, end, c_.crease}, {front, y, c_.crease}, nose});
    builder_->add_face(structure, {{front, y, c_.crease}, at(front, c_.nose + 0.02), nose});
    builder_->add_face(
        structure,
        {{l - rear, y, c_.sill}, {l, end, c_.sill}, {l, end, c_.crease}, {l - rear, y, c_.crease}});
    builder_->add_face(structure, {{l - rear, y, c_.crease}, {l, end, c_.crease}, tail});
    builder_->add_face(structure, {{l - rear, y, c_.crease}, tail, at(l - rear, boot)});
    // Door handles.
    for (double x : {handle - 0.1, handle + 0.75}) {
      if (x + 0.2 > c_.rear_axle) continue;
      add_box(builder_, {x, y - 0.025, c_.crease - 0.05}, {x + 0.16, y + 0.001, c_.crease - 0.015},
              structure, {kBack});
    }
    if (c_.boot) {  // from the shoulder up to the boot
      builder_->add_face(kTouching, {at(c_.rear_window_end * 0.98, c_.belt),
                                     at(l - rear, boot),
                                     {c_.rear_window_end, -c_.half_belt(), c_.boot_height}});
    }
    // The shoulder under the windows.
    builder_->add_face(kTouching, {{c_.bonnet_end, top, c_.belt},
                                   {c_.rear_window_end * 0.98, top, c_.belt},
                                   {c_.rear_window_end * 0.98, -c_.half_belt(), c_.belt + 0.01},
                                   {c_.bonnet_end, -c_.half_belt(), c_.belt + 0.01}});
  }

  /// An arch's points from its front foot over the top to its rear foot.
  std::vector<Vector2d> arch_of(double axle) const {
    constexpr int kSteps = 8;
    const double radius = c_.wheel + 0.05, z = c_.wheel;
    const double foot = std::asin(std::clamp((c_.sill - z) / radius, -1.0, 1.0));
    std::vector<Vector2d> out;
    for (int i = 0; i <= kSteps; ++i) {
      const double angle = M_PI - foot + (2.0 * foot - M_PI) * i / kSteps;
      out.push_back({axle + radius * std::cos(angle), z + radius * std::sin(angle)});
    }
    return out;
  }

  void add_windows(int structure) {
    const Vector3d low(0.0, -c_.half_belt(), c_.belt + 0.01), high(0.0, -c_.half_roof(), c_.roof);
    const Vector3d v = (high - low).normalized();
    const double rise = (high - low).norm();
    const double x0 = c_.bonnet_end, x1 = c_.roof_start, x2 = c_.roof_end;
    const double x3 = std::min(c_.rear_window_end, c_.length - 0.03);
    const std::vector<Vector2d> outline = {{x0, 0.0}, {x3, 0.0}, {x2, rise}, {x1, rise}};
    // Panes inside, parted by pillars.
    const double edge = 0.06, pillar = 0.05;
    const double from_low = x0 + 2.5 * edge, from_high = x1 + edge;
    const double to_low = x3 - 2.5 * edge, to_high = x2 - edge;
    const int panes = to_low - from_low > 1.9 ? 3 : 2;
    std::vector<Inset> insets;
    for (int i = 0; i < panes; ++i) {
      const auto mix = [&](double a, double b, int k) { return a + (b - a) * k / panes; };
      const double a = mix(from_low, to_low, i) + (i > 0 ? pillar : 0.0);
      const double b = mix(from_low, to_low, i + 1) - (i + 1 < panes ? pillar : 0.0);
      const double d = mix(from_high, to_high, i) + (i > 0 ? pillar : 0.0);
      const double e = mix(from_high, to_high, i + 1) - (i + 1 < panes ? pillar : 0.0);
      if (b - a < 0.12 || e - d < 0.08) continue;
      insets.push_back({{{a, edge}, {b, edge}, {e, rise - edge}, {d, rise - edge}}, 0.015});
    }
    add_panel(builder_, structure, low, Vector3d::UnitX(), v, outline, insets);
  }

  void add_wheel(int structure, double axle) {
    constexpr int kSteps = 14;
    const double y = -c_.half_width() + 0.012, r = c_.wheel, rim = 0.62 * r, depth = 0.1;
    const auto ring = [&](double radius, double at) {
      SurfaceBuilder::Ring out;
      for (int i = 0; i < kSteps; ++i) {
        const double angle = 2.0 * M_PI * (i + 0.5) / kSteps;
        out.push_back({axle + radius * std::cos(angle), at, r + radius * std::sin(angle)});
      }
      return out;
    };
    builder_->add_face(structure, ring(r, y), {ring(rim, y)});
    SurfaceBuilder::Ring outer = ring(rim, y), inner = ring(0.9 * rim, y + 0.025);
    SurfaceBuilder::Ring tread = ring(r, y), behind = ring(r, y + depth);
    builder_->add_face(structure, inner);
    for (SurfaceBuilder::Ring* closed : {&outer, &inner, &tread, &behind}) {
      closed->push_back(closed->front());
    }
    add_loft(builder_, structure, outer, inner);
    for (int i = 0; i < kSteps; ++i) {
      if (std::max(tread[i].z(), tread[i + 1].z()) > c_.sill + 0.05) continue;
      builder_->add_face(kTouching, {tread[i + 1], tread[i], behind[i], behind[i + 1]});
    }
    // The arch's lining from the body inwards, and the dark gap between it and the wheel.
    const std::vector<Vector2d> arch_points = arch_of(axle);
    const double deep = -c_.half_width() + 0.04;
    SurfaceBuilder::Ring rim_line, gap_line, wheel_line;
    for (const Vector2d& p : arch_points) {
      const Vector2d hub(axle, r);
      const Vector2d q = hub + r * (p - hub).normalized();
      rim_line.push_back({p.x(), -c_.half_width(), p.y()});
      gap_line.push_back({p.x(), deep, p.y()});
      wheel_line.push_back({q.x(), deep, q.y()});
    }
    add_loft(builder_, structure, rim_line, gap_line);
    const int gap = builder_->add_detail(structure);
    for (size_t i = 0; i + 1 < arch_points.size(); ++i) {
      builder_->add_polygon(gap, {gap_line[i], gap_line[i + 1], wheel_line[i + 1], wheel_line[i]});
    }
    // The tyre from its outside to the gap.
    const int last = static_cast<int>(arch_points.size()) - 1;
    for (int i = 0; i < last; ++i) {
      const Vector3d out(0.0, y - deep, 0.0);
      builder_->add_face(structure, {wheel_line[i], wheel_line[i + 1], wheel_line[i + 1] + out,
                                     wheel_line[i] + out});
    }
  }

  void add_mirror() {
    const double x = c_.bonnet_end + 0.22, y = -c_.half_width(), z = c_.belt;
    add_box(builder_, {x, y - 0.12, z + 0.02}, {x + 0.09, y + c_.shoulder + 0.06, z + 0.13},
            kTouching, {kBack});
  }

  const CarShape& c_;
  SurfaceBuilder* builder_;
};

}  // namespace

void add_car_side(const CarShape& car, bool left, SurfaceBuilder* builder) {
  Eigen::Affine3d pose = Eigen::Affine3d::Identity();
  if (left) pose.linear()(1, 1) = -1.0;
  builder->set_pose(pose);
  CarSide(car, builder).add();
  builder->set_pose(Eigen::Affine3d::Identity());
}

}  // namespace gable
