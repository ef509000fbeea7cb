#include <gable/grammar/solid/block_alignment.h>
#include <gable/grammar/solid/house_frame.h>
#include <gable/grammar/solid/part_solids.h>
#include <gable/grammar/solid/roof_slabs.h>
#include <gable/grammar/solid/slab_plan.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace gable {
namespace {

constexpr int kNumAttempts = 24;
constexpr double kLeastVolume = 0.005;

// A house without the details that show nothing, and which of the original's its details are.
struct VisibleHouse {
  House house;
  std::vector<int> garages, dormers, chimneys;
};

void keep_visible(const std::vector<HousePart>& parts, PartRole role, std::vector<Rule>* rules,
                  std::vector<int>* kept) {
  std::vector<Rule> visible;
  for (int i = 0; i < static_cast<int>(rules->size()); ++i) {
    const bool shows = std::any_of(parts.begin(), parts.end(), [&](const HousePart& part) {
      return part.role == role && part.index == i;
    });
    if (!shows) continue;
    visible.push_back((*rules)[i]);
    kept->push_back(i);
  }
  *rules = std::move(visible);
}

VisibleHouse visible_house(const House& house, const std::vector<HousePart>& parts) {
  VisibleHouse visible{house, {}, {}, {}};
  keep_visible(parts, PartRole::kGarage, &visible.house.garages, &visible.garages);
  keep_visible(parts, PartRole::kDormer, &visible.house.dormers, &visible.dormers);
  keep_visible(parts, PartRole::kChimney, &visible.house.chimneys, &visible.chimneys);
  return visible;
}

// The house with its roofs lowered, so that its walls end under slabs of this thickness.
House lowered(House house, double thickness, bool with_dormers) {
  for (Rule& roof : house.roofs) roof[param::roof::kEaves] -= thickness;
  for (Rule& garage : house.garages) {
    garage[garage.kind == RuleKind::kGarageL ? param::garage::kHeightL : param::garage::kHeightI] -=
        thickness;
  }
  if (with_dormers) {
    for (Rule& dormer : house.dormers) dormer[param::dormer::kEaves] -= thickness;
  }
  return house;
}

std::vector<SlabBlock> slab_blocks(const std::vector<BlockSource>& sources,
                                   const BlockAlignment& alignment, const Shake& shake,
                                   bool with_dormers) {
  const std::vector<Block<double>> blocks = alignment.blocks(shake);
  std::vector<SlabBlock> result;
  std::optional<std::pair<BlockRole, int>> last;
  int part = -1;
  for (size_t i = 0; i < blocks.size(); ++i) {
    if (!alignment.has_area(static_cast<int>(i))) continue;
    const BlockRole role = sources[i].role;
    const std::pair<BlockRole, int> own(role, role == BlockRole::kComponent ? 0 : sources[i].index);
    if (last != own) ++part;
    last = own;
    result.push_back({blocks[i], part, role == BlockRole::kDormer,
                      role != BlockRole::kChimney && (with_dormers || role != BlockRole::kDormer)});
  }
  return result;
}

// Gives each block a sheet: blocks of one part share it unless their slabs lie over one another
// somewhere. Nothing where the plan cannot be divided.
std::optional<std::vector<int>> sheets_of(const SlabPlan& plan,
                                          const std::vector<SlabBlock>& blocks) {
  std::set<std::pair<int, int>> stacked;
  const auto observe = [&](const Eigen::Vector2d& p) {
    const std::vector<SlabPiece> pieces = plan.at(p);
    for (const SlabPiece& a : pieces) {
      for (const SlabPiece& b : pieces) stacked.insert({a.block, b.block});
    }
    return pieces.empty() ? CellLabel{} : pieces.front().label;
  };
  if (!divide_plan(plan.segments(), observe, plan.planes())) return std::nullopt;
  std::vector<int> sheets(blocks.size(), -1);
  int num_sheets = 0;
  for (size_t b = 0; b < blocks.size(); ++b) {
    for (int sheet = 0; sheet < num_sheets && sheets[b] < 0; ++sheet) {
      bool fits = true;
      for (size_t other = 0; other < b; ++other) {
        if (sheets[other] != sheet) continue;
        fits = fits && blocks[other].part == blocks[b].part &&
               !stacked.contains({static_cast<int>(other), static_cast<int>(b)});
      }
      if (fits) sheets[b] = sheet;
    }
    if (sheets[b] < 0) sheets[b] = num_sheets++;
  }
  return sheets;
}

std::optional<std::vector<Solid>> slabs_of(const SlabPlan& plan,
                                           const std::vector<SlabBlock>& blocks) {
  const std::optional<std::vector<int>> sheets = sheets_of(plan, blocks);
  if (!sheets) return std::nullopt;
  std::vector<Solid> slabs;
  for (int sheet = 0; sheet <= *std::max_element(sheets->begin(), sheets->end()); ++sheet) {
    const auto label = [&](const Eigen::Vector2d& p) {
      for (const SlabPiece& piece : plan.at(p)) {
        if ((*sheets)[piece.block] == sheet) return piece.label;
      }
      return CellLabel{};
    };
    std::optional<std::vector<Solid>> solids =
        solids_over_plan(plan.segments(), label, plan.planes(), kLeastVolume);
    if (!solids) return std::nullopt;
    for (Solid& solid : *solids) slabs.push_back(std::move(solid));
  }
  return slabs;
}

std::optional<std::vector<Solid>> build_slabs(const House& house, double base,
                                              const RoofSlabOptions& options,
                                              const std::vector<PlanPolygon>& neighbours,
                                              bool with_dormers) {
  const std::vector<BlockSource> sources = block_sources(house);
  const BlockAlignment alignment(expand_blocks(house), base);
  for (int attempt = 0; attempt < kNumAttempts; ++attempt) {
    const std::vector<SlabBlock> blocks =
        slab_blocks(sources, alignment, shake_of_attempt(attempt), with_dormers);
    if (blocks.empty()) return std::nullopt;
    const SlabPlan plan(blocks, options.overhang, options.thickness, base, neighbours);
    std::optional<std::vector<Solid>> slabs = slabs_of(plan, blocks);
    if (slabs) return slabs;
  }
  return std::nullopt;
}

}  // namespace

std::string check(const RoofSlabOptions& options) {
  if (options.thickness != 0.0 && !(options.thickness >= 0.05 && options.thickness <= 1.0)) {
    return "thickness must be 0 or lie in [0.05, 1] m";
  }
  if (!(options.overhang >= 0.0 && options.overhang <= 1.0)) {
    return "overhang must lie in [0, 1] m";
  }
  if (options.overhang > 0.0 && options.thickness == 0.0) return "an overhang needs a thickness";
  return "";
}

HouseSolids build_roof_slabs(const House& house, double base, const RoofSlabOptions& options,
                             const std::vector<PlanPolygon>& neighbours) {
  HouseSolids result;
  if (!options.wanted()) return result;
  const HouseSolids whole = build_house_solids(house, Lod::k22, base);
  if (whole.parts.empty()) return result;
  const VisibleHouse visible = visible_house(house, whole.parts);
  std::vector<PlanPolygon> next_door;
  for (const PlanPolygon& neighbour : neighbours) {
    next_door.push_back(house_from_local(neighbour, house.azimuth[0]));
  }
  for (const bool with_dormers : {true, false}) {
    if (!with_dormers && visible.dormers.empty()) break;
    std::optional<std::vector<Solid>> slabs =
        build_slabs(visible.house, base, options, next_door, with_dormers);
    if (!slabs || slabs->empty()) continue;
    HouseSolids under =
        build_house_solids(lowered(visible.house, options.thickness, with_dormers), Lod::k22, base);
    // All that is left shows: whatever is dropped has no valid solid.
    if (!under.dropped.empty()) continue;
    for (HousePart& part : under.parts) {
      if (part.role == PartRole::kGarage) part.index = visible.garages[part.index];
      if (part.role == PartRole::kDormer) part.index = visible.dormers[part.index];
      if (part.role == PartRole::kChimney) part.index = visible.chimneys[part.index];
      result.parts.push_back(std::move(part));
    }
    for (size_t i = 0; i < slabs->size(); ++i) {
      turn_to_local(house.azimuth[0], &(*slabs)[i]);
      result.parts.push_back({PartRole::kRoofSlab, static_cast<int>(i), std::move((*slabs)[i])});
    }
    if (!with_dormers) result.dropped.push_back("roof slabs of the dormers: no valid solid");
    return result;
  }
  result.dropped.push_back("roof slabs: no valid solid");
  return result;
}

}  // namespace gable
