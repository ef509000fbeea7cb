#include <gable/grammar/height_field.h>
#include <gable/grammar/solid/roof_facets.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gable {
namespace {

constexpr double kNoLength = 1e-9;  // metres

using Polygon = std::vector<Eigen::Vector2d>;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// The part of a convex polygon where `keep` is not negative.
Polygon clip(const Polygon& polygon, const Plane& keep) {
  Polygon clipped;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& p = polygon[i];
    const Eigen::Vector2d& q = polygon[(i + 1) % polygon.size()];
    const double at_p = keep.at(p), at_q = keep.at(q);
    if (at_p >= 0.0) clipped.push_back(p);
    if ((at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0)) {
      clipped.push_back(p + (q - p) * (at_p / (at_p - at_q)));
    }
  }
  return clipped;
}

// Cuts the segment from `from` to `to` to the left side of the line through p and q.
bool cut_to_left(const Eigen::Vector2d& p, const Eigen::Vector2d& q, PlanSegment* segment) {
  // Where three planes meet at a corner, clipping leaves edges of no length and any direction.
  if ((q - p).squaredNorm() < kNoLength * kNoLength) return true;
  const double at_from = cross(q - p, segment->from - p);
  const double at_to = cross(q - p, segment->to - p);
  if (at_from < 0.0 && at_to < 0.0) return false;
  const Eigen::Vector2d from = segment->from, to = segment->to;
  if (at_from < 0.0) segment->from = from + (to - from) * (at_from / (at_from - at_to));
  if (at_to < 0.0) segment->to = from + (to - from) * (at_from / (at_from - at_to));
  return true;
}

bool cut_to_polygon(const Polygon& polygon, PlanSegment* segment) {
  for (size_t i = 0; i < polygon.size(); ++i) {
    if (!cut_to_left(polygon[i], polygon[(i + 1) % polygon.size()], segment)) return false;
  }
  return true;
}

Polygon rectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

// The line where two planes meet, cut to a facet of each.
bool meeting_line(const RoofFacet& facet, const RoofFacet& other, const std::vector<Plane>& planes,
                  const Polygon& region, PlanSegment* segment) {
  const Plane& p = planes[facet.plane];
  const Plane& q = planes[other.plane];
  const Eigen::Vector2d gradient(p.a - q.a, p.b - q.b);
  const double slope = gradient.norm();
  if (slope < 1e-9) return false;
  const Eigen::Vector2d normal = gradient / slope;
  const Eigen::Vector2d& near = facet.outline.front();
  const Eigen::Vector2d foot = near - normal * ((p.at(near) - q.at(near)) / slope);
  const Eigen::Vector2d along(-normal.y(), normal.x());
  const double reach =
      2.0 * (region[2] - region[0]).norm() + (near - region[0]).norm() + (foot - near).norm();
  *segment = {foot - along * reach, foot + along * reach};
  return cut_to_polygon(facet.outline, segment) && cut_to_polygon(other.outline, segment) &&
         cut_to_polygon(region, segment);
}

// The plane of a facet: what its height is, linear in the point.
Plane facet_plane(const Block<double>& block, Facet facet) {
  using namespace block_value;
  const double x = 0.5 * (block[kX0] + block[kX1]), y = 0.5 * (block[kY0] + block[kY1]);
  const double z = facet_height<double, double>(block, facet, x, y);
  const double a = facet_height<double, double>(block, facet, x + 1.0, y) - z;
  const double b = facet_height<double, double>(block, facet, x, y + 1.0) - z;
  return {a, b, z - a * x - b * y};
}

}  // namespace

int FacetedBlock::plane_at(const Eigen::Vector2d& p, const std::vector<Plane>& planes) const {
  int lowest = facets.front().plane;
  double height = planes[lowest].at(p);
  for (const RoofFacet& facet : facets) {
    const double z = planes[facet.plane].at(p);
    if (z < height) {
      height = z;
      lowest = facet.plane;
    }
  }
  return lowest;
}

FacetedBlock facet_block(const Block<double>& block, PlaneSet* planes, double margin) {
  using namespace block_value;
  FacetedBlock faceted;
  faceted.low = {block[kX0] - margin, block[kY0] - margin};
  faceted.high = {block[kX1] + margin, block[kY1] + margin};
  std::vector<Plane> roof;
  std::vector<int> numbers;
  for (int f = 0; f < kNumFacets; ++f) {
    if (!has_facet(block, static_cast<Facet>(f))) continue;
    const Plane plane = facet_plane(block, static_cast<Facet>(f));
    const int number = planes->number_of(plane);
    // Where a side is not broken, both its parts lie in one plane.
    if (std::find(numbers.begin(), numbers.end(), number) != numbers.end()) continue;
    roof.push_back(plane);
    numbers.push_back(number);
  }
  for (size_t i = 0; i < roof.size(); ++i) {
    RoofFacet facet{numbers[i], rectangle(faceted.low, faceted.high)};
    for (size_t j = 0; j < roof.size() && facet.outline.size() >= 3; ++j) {
      if (j == i) continue;
      facet.outline = clip(facet.outline,
                           {roof[j].a - roof[i].a, roof[j].b - roof[i].b, roof[j].c - roof[i].c});
    }
    if (facet.outline.size() >= 3) faceted.facets.push_back(std::move(facet));
  }
  return faceted;
}

void append_meeting_lines(const FacetedBlock& block, const FacetedBlock& other,
                          const std::vector<Plane>& planes, const Eigen::Vector2d& low,
                          const Eigen::Vector2d& high, std::vector<PlanSegment>* segments) {
  if ((block.high.array() < other.low.array()).any() ||
      (other.high.array() < block.low.array()).any()) {
    return;
  }
  const Polygon region = rectangle(low, high);
  for (const RoofFacet& facet : block.facets) {
    for (const RoofFacet& second : other.facets) {
      PlanSegment segment;
      if (facet.plane != second.plane && meeting_line(facet, second, planes, region, &segment)) {
        segments->push_back(segment);
      }
    }
  }
}

std::vector<PlanSegment> envelope_segments(const std::vector<const FacetedBlock*>& blocks,
                                           const std::vector<Plane>& planes,
                                           const Eigen::Vector2d& low,
                                           const Eigen::Vector2d& high) {
  const Polygon region = rectangle(low, high);
  std::vector<PlanSegment> segments;
  // Rectangles first: where points are merged, the earliest one stays.
  const auto add_outline = [&](const Polygon& outline) {
    for (size_t i = 0; i < outline.size(); ++i) {
      PlanSegment segment{outline[i], outline[(i + 1) % outline.size()]};
      if (cut_to_polygon(region, &segment)) segments.push_back(segment);
    }
  };
  for (const FacetedBlock* block : blocks) add_outline(rectangle(block->low, block->high));
  for (const FacetedBlock* block : blocks) {
    if (block->facets.size() < 2) continue;
    for (const RoofFacet& facet : block->facets) add_outline(facet.outline);
  }
  for (size_t i = 0; i < blocks.size(); ++i) {
    for (size_t j = i + 1; j < blocks.size(); ++j) {
      append_meeting_lines(*blocks[i], *blocks[j], planes, low, high, &segments);
    }
  }
  return segments;
}

}  // namespace gable
