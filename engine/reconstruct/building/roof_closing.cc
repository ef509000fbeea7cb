#include <gable/engine/closing/close_planes.h>
#include <gable/engine/reconstruct/building/roof_closing.h>
#include <gable/engine/scales/outline/ring_simplification.h>

#include <utility>
#include <vector>

namespace gable {
namespace {

PlanPolygon simplified_outline(const PlanPolygon& outline, double tolerance) {
  std::vector<Ring> rings = {outline.outer};
  rings.insert(rings.end(), outline.holes.begin(), outline.holes.end());
  // Rings that meet are simplified for what they are: even-odd.
  rings = simplified(rings, tolerance);
  if (rings.empty()) return outline;
  PlanPolygon result;
  result.outer = std::move(rings.front());
  for (size_t i = 1; i < rings.size(); ++i) result.holes.push_back(std::move(rings[i]));
  return result;
}

std::vector<HeightSample> samples_of(const HeightImage& image) {
  std::vector<HeightSample> samples;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t i = image.index(row, col);
      if (!image.inside[i] || !is_evidence(image, i)) continue;
      const Eigen::Vector2d p = image.center_of(row, col);
      samples.push_back({{p.x(), p.y(), image.height[i]}, image.gsd * image.gsd});
    }
  }
  return samples;
}

}  // namespace

std::string check(const RoofClosingOptions& options) {
  if (std::string error = check(options.scales); !error.empty()) return error;
  if (std::string error = check(options.closing); !error.empty()) return error;
  if (!(options.outline_tolerance >= 0.0 && options.outline_tolerance <= 10.0)) {
    return "outline_tolerance must lie in [0, 10] m";
  }
  return "";
}

std::string close_roof(const HeightImage& image, const RoofClosingOptions& options,
                       Building* building) {
  const HouseScales scales = house_scales(image, nullptr, options.scales);
  std::vector<Plane> planes;
  for (const HousePlane& plane : scales.roofs().planes) planes.push_back(plane.plane);
  ClosedPlanes closed =
      close_planes(simplified_outline(building->outline, options.outline_tolerance), planes,
                   samples_of(image), building->base, options.closing);
  if (!closed.reason.empty()) return closed.reason;
  building->status = BuildingStatus::kPlanes;
  building->roof = std::move(closed.roof);
  return "";
}

}  // namespace gable
