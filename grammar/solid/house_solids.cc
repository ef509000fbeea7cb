#include <gable/grammar/block.h>
#include <gable/grammar/ring.h>
#include <gable/grammar/solid/block_alignment.h>
#include <gable/grammar/solid/house_frame.h>
#include <gable/grammar/solid/house_solids.h>
#include <gable/grammar/solid/part_solids.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

namespace gable {
namespace {

constexpr int kNumAttempts = 24;

// Blocks that make up one part: its role, number and blocks [begin, end).
struct PartBlocks {
  PartRole role;
  int index;
  int begin, end;
};

PartRole part_role(BlockRole role) {
  switch (role) {
    case BlockRole::kComponent:
      return PartRole::kMain;
    case BlockRole::kGarage:
      return PartRole::kGarage;
    case BlockRole::kDormer:
      return PartRole::kDormer;
    default:
      return PartRole::kChimney;
  }
}

std::string rule_title(PartRole role, int index) {
  constexpr const char* kNames[] = {"main roofs", "garage", "dormer", "chimney"};
  const std::string name = kNames[static_cast<int>(role)];
  return role == PartRole::kMain ? name : name + " " + std::to_string(index + 1);
}

bool is_finite(const Block<double>& block) {
  return std::all_of(block.values.begin(), block.values.end(),
                     [](double v) { return std::isfinite(v); });
}

// A flat top two thirds up the rise: between a gable roof's mean height and its ridge.
void flatten(Block<double>* block) {
  using namespace block_value;
  if (block->flat) return;
  (*block)[kEaves] += (*block)[kRise] * (2.0 / 3.0);
  (*block)[kRise] = (*block)[kHipStart] = (*block)[kHipEnd] = 0.0;
  block->flat = true;
  block->mansard = false;
}

// outline: house frame, or null.
std::optional<std::vector<Solid>> build_part(const BlockAlignment& alignment,
                                             const std::vector<BlockSource>& sources,
                                             const PartBlocks& part, double base,
                                             const KnownOutline* outline) {
  const std::vector<Block<double>> still = alignment.blocks();
  for (int attempt = 0; attempt < kNumAttempts; ++attempt) {
    const std::vector<Block<double>> moved = alignment.blocks(shake_of_attempt(attempt));
    // What stands below has been built where it is: prefer to leave it there.
    const bool move_below = attempt > kNumAttempts / 2;
    std::vector<PartBlock> own, below;
    std::optional<OutlineCover> cover;
    if (outline) {
      const PlanPolygon aligned = alignment.outline(outline->polygon, shake_of_attempt(attempt));
      cover.emplace(OutlineCover{{aligned, outline->reach}, {}});
    }
    for (int i = 0; i < static_cast<int>(sources.size()); ++i) {
      if (!alignment.has_area(i)) continue;
      const bool ground = !stands_on_roof(sources[i].role);
      const bool mine = i >= part.begin && i < part.end;
      const Block<double>& block = mine || move_below ? moved[i] : still[i];
      if (cover && ground) cover->ground_blocks.push_back(block);
      if (i < part.end) (mine ? own : below).push_back({block, ground});
    }
    if (std::optional<std::vector<Solid>> solids =
            solids_above(own, below, base, cover ? &*cover : nullptr)) {
      return solids;
    }
  }
  return std::nullopt;
}

// Whether the ground faces of a solid in the house frame cover a point of the plan.
bool stands_over(const Solid& solid, const Eigen::Vector2d& p) {
  for (const Face& face : solid.faces) {
    if (face.type != SurfaceType::kGround) continue;
    int inside = 0;
    for (const std::vector<int>& ring : face.rings) {
      std::vector<Eigen::Vector2d> points;
      for (const int v : ring) points.push_back(solid.vertices[v].head<2>());
      inside += ring_holds(points, p);
    }
    if (inside == 1) return true;
  }
  return false;
}

// Sorts the main bodies by the first component that each stands over.
void sort_bodies(const std::vector<Block<double>>& components, std::vector<Solid>* bodies) {
  using namespace block_value;
  std::vector<std::pair<size_t, size_t>> order;
  for (size_t b = 0; b < bodies->size(); ++b) {
    size_t first = 0;
    for (; first < components.size(); ++first) {
      const Block<double>& c = components[first];
      if (stands_over((*bodies)[b], {0.5 * (c[kX0] + c[kX1]), 0.5 * (c[kY0] + c[kY1])})) break;
    }
    order.emplace_back(first, b);
  }
  std::sort(order.begin(), order.end());
  std::vector<Solid> sorted;
  for (const auto& [first, b] : order) sorted.push_back(std::move((*bodies)[b]));
  *bodies = std::move(sorted);
}

std::vector<PartBlocks> parts_of(const std::vector<BlockSource>& sources, Lod lod) {
  std::vector<PartBlocks> parts;
  const int n = static_cast<int>(sources.size());
  for (int i = 0; i < n; ++i) {
    const PartRole role = part_role(sources[i].role);
    if (lod != Lod::k22 && (role == PartRole::kDormer || role == PartRole::kChimney)) break;
    const int index = role == PartRole::kMain ? 0 : sources[i].index;
    if (parts.empty() || parts.back().role != role || parts.back().index != index) {
      parts.push_back({role, index, i, i});
    }
    parts.back().end = i + 1;
  }
  return parts;
}

}  // namespace

HouseSolids build_house_solids(const House& house, Lod lod, double base,
                               const KnownOutline& outline) {
  HouseSolids result;
  if (!is_well_formed(house)) {
    result.dropped.push_back("house: not a derivation of the grammar");
    return result;
  }
  std::vector<Block<double>> blocks = expand_blocks(house);
  const bool finite = std::isfinite(base) && std::isfinite(house.azimuth[0]) &&
                      std::all_of(blocks.begin(), blocks.end(), is_finite);
  if (!finite) {
    result.dropped.push_back("house: a parameter is not a number");
    return result;
  }
  if (lod == Lod::k12) {
    for (Block<double>& block : blocks) flatten(&block);
  }
  const BlockAlignment alignment(blocks, base);
  const KnownOutline turned{house_from_local(outline.polygon, house.azimuth[0]), outline.reach};
  const KnownOutline* cover = outline.empty() ? nullptr : &turned;
  const std::vector<BlockSource> sources = block_sources(house);
  for (const PartBlocks& part : parts_of(sources, lod)) {
    std::optional<std::vector<Solid>> solids = build_part(alignment, sources, part, base, cover);
    const std::string title = rule_title(part.role, part.index);
    if (!solids && part.role == PartRole::kMain) {
      result.dropped.push_back(title + ": no valid solid, built with flat tops");
      for (int i = part.begin; i < part.end; ++i) flatten(&blocks[i]);
      solids = build_part(BlockAlignment(blocks, base), sources, part, base, cover);
    }
    if (!solids) {
      result.dropped.push_back(title + ": no valid solid");
      continue;
    }
    if (solids->empty()) {
      result.dropped.push_back(title + ": nothing shows above what stands below");
      continue;
    }
    if (part.role == PartRole::kMain) {
      sort_bodies({blocks.begin(), blocks.begin() + part.end}, &*solids);
    }
    for (size_t i = 0; i < solids->size(); ++i) {
      turn_to_local(house.azimuth[0], &(*solids)[i]);
      const int index = part.role == PartRole::kMain ? static_cast<int>(i) : part.index;
      result.parts.push_back({part.role, index, std::move((*solids)[i])});
    }
  }
  return result;
}

}  // namespace gable
