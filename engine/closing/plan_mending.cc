#include <gable/engine/closing/plan_mending.h>
#include <gable/engine/closing/roof_defects.h>
#include <gable/grammar/random.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

namespace gable {
namespace {

// Places nearer than this to each other, metres, are too near for a solid (ValidityTolerance), and
// what lies this near to such a place is moved, by up to so much, so many times.
constexpr double kLeastApart = 0.004;
constexpr double kBesideCrowd = 0.01;
constexpr double kAside = 0.02;
constexpr int kMaxMendings = 40;
constexpr int kPlainMendings = 3;  // of them, for saddles
constexpr int kDirections = 16;    // in which it is looked what there is

// A step into a sector of a corner, well clear of where cells are told apart, metres.
constexpr double kIntoSector = 1e-3;

/// Moves one thing at every crowded corner: a line of steps there, a corner of the outline, or a
/// plane up or down. At first what most likely moves nothing else, the line that came last or the
/// plane of fewest cells, then any.
void loosen(const std::vector<CrowdedCorner>& crowded, bool first, Random* random,
            LabelledPlan* labelled, std::vector<Plane>* planes) {
  const auto aside = [&] { return random->uniform(-kAside, kAside); };
  std::vector<int> cells(planes->size(), 0);
  for (const int l : labelled->labels) ++cells[l];
  const auto least_used = [&](const std::vector<int>& some) {
    return *std::min_element(some.begin(), some.end(),
                             [&](int a, int b) { return cells[a] < cells[b]; });
  };
  std::vector<Eigen::Vector2d*> corners;
  for (Eigen::Vector2d& p : labelled->outline.outer) corners.push_back(&p);
  for (auto& hole : labelled->outline.holes) {
    for (Eigen::Vector2d& p : hole) corners.push_back(&p);
  }
  std::vector<uint8_t> move(labelled->lines.size(), 0), lift(planes->size(), 0);
  for (const CrowdedCorner& corner : crowded) {
    if (!corner.nearly_level.empty()) {
      lift[first ? least_used(corner.nearly_level)
                 : corner.nearly_level[random->integer(
                       0, static_cast<int>(corner.nearly_level.size()) - 1)]] = 1;
      continue;
    }
    std::vector<int> steps, there;
    std::vector<Eigen::Vector2d*> ends;
    for (const int number : labelled->division.lines_near(corner.place, kBesideCrowd)) {
      if (!labelled->lines[number].is_crease()) steps.push_back(number);
    }
    for (Eigen::Vector2d* p : corners) {
      if ((*p - corner.place).norm() < kBesideCrowd) ends.push_back(p);
    }
    for (int k = 0; k < kDirections; ++k) {
      const double angle = 2.0 * M_PI * k / kDirections;
      const Eigen::Vector2d around(std::cos(angle), std::sin(angle));
      const int cell = labelled->division.cell_at(corner.place + kBesideCrowd * around);
      if (cell >= 0) there.push_back(labelled->labels[cell]);
    }
    const int kinds = !steps.empty() + !ends.empty() + !there.empty();
    int kind = first || kinds == 0 ? 0 : random->integer(0, kinds - 1);
    if (!steps.empty() && kind-- == 0) {
      move[first ? steps.back() : steps[random->integer(0, static_cast<int>(steps.size()) - 1)]] =
          1;
    } else if (!ends.empty() && kind-- == 0) {
      for (Eigen::Vector2d* p : ends) *p += Eigen::Vector2d{aside(), aside()};
    } else if (!there.empty()) {
      lift[least_used(there)] = 1;
    }
  }
  for (size_t i = 0; i < planes->size(); ++i) {
    if (lift[i]) (*planes)[i].c += aside();
  }
  for (size_t i = 0; i < labelled->lines.size(); ++i) {
    PlanLine& line = labelled->lines[i];
    if (move[i]) line.offset += aside();
    if (!line.is_crease() || !(lift[line.a] || lift[line.b])) continue;
    if (const auto crease = crease_of(*planes, line.a, line.b)) {
      line.normal = crease->normal;
      line.offset = crease->offset;
    }
  }
}

/// Gives the smallest cell around a saddle the plane of one beside it: if possible one that stands
/// out from its neighbours or between them, which gets that of the neighbour nearer in height.
/// Where that was tried (not `first`), any cell there gets the plane of any beside it.
void level_saddle(const RoofSaddle& saddle, const std::vector<Plane>& planes, double least,
                  bool first, Random* random, LabelledPlan* labelled) {
  const auto height = [&](const RoofSector& sector) {
    return sector.plane < 0 ? -std::numeric_limits<double>::infinity()
                            : planes[sector.plane].at(saddle.place);
  };
  struct Change {
    bool on_the_way = true;  // up or down from one neighbour to the other
    double area = std::numeric_limits<double>::infinity(), step = area;
    int cell = -1, plane = -1;
  };
  std::vector<Change> changes;
  const size_t n = saddle.sectors.size();
  for (size_t i = 0; i < n; ++i) {
    const RoofSector& own = saddle.sectors[i];
    const int cell = labelled->division.cell_at(saddle.place + kIntoSector * own.into);
    if (own.plane < 0 || cell < 0) continue;
    const std::vector<Eigen::Vector2d> corners = labelled->division.corners(cell);
    const RoofSector &before = saddle.sectors[(i + n - 1) % n],
                     &after = saddle.sectors[(i + 1) % n];
    const double z = height(own);
    for (const RoofSector& beside : {before, after}) {
      if (beside.plane < 0 || beside.plane == own.plane) continue;
      const bool stands = std::all_of(corners.begin(), corners.end(), [&](const auto& p) {
        return planes[beside.plane].at(p) >= least;
      });
      if (!stands) continue;
      changes.push_back({(height(before) - z) * (height(after) - z) <= 0.0,
                         labelled->division.area(cell), std::abs(height(beside) - z), cell,
                         beside.plane});
    }
  }
  if (changes.empty()) return;
  const auto better = [](const Change& x, const Change& y) {
    return std::tie(x.on_the_way, x.area, x.step) < std::tie(y.on_the_way, y.area, y.step);
  };
  const Change& change = first ? *std::min_element(changes.begin(), changes.end(), better)
                               : changes[random->integer(0, static_cast<int>(changes.size()) - 1)];
  labelled->labels[change.cell] = change.plane;
}

}  // namespace

std::optional<MendedPlan> mend_plan(LabelledPlan labelled, PlaneChoice choice, double base,
                                    double clearance) {
  Random random(0);
  for (int attempt = 0; attempt <= kMaxMendings; ++attempt) {
    choice = used_planes(choice, &labelled);
    std::optional<RoofPartition> roof = partition_of(labelled, choice.planes);
    if (!roof || roof->planes.size() != choice.planes.size()) return std::nullopt;
    const RoofDefects defects = find_roof_defects(*roof, kLeastApart);
    const bool whole = defects.crowded.empty() && defects.saddles.empty();
    if (whole || attempt == kMaxMendings) {
      std::optional<std::vector<Solid>> solids = solids_of_partition(*roof, base);
      if (!solids || solids->empty()) return std::nullopt;
      return MendedPlan{std::move(*roof), std::move(*solids), std::move(choice.origins),
                        labelled.division.num_cells()};
    }
    for (const RoofSaddle& saddle : defects.saddles) {
      level_saddle(saddle, choice.planes, base + clearance, attempt < kPlainMendings, &random,
                   &labelled);
    }
    if (defects.crowded.empty()) continue;
    const LabelledPlan before = labelled;
    loosen(defects.crowded, attempt == 0, &random, &labelled, &choice.planes);
    std::optional<PlanDivision> division = PlanDivision::make(labelled.outline, labelled.lines);
    if (!division) return std::nullopt;
    labelled.division = std::move(*division);
    labelled.labels.resize(labelled.division.num_cells());
    for (int c = 0; c < labelled.division.num_cells(); ++c) {
      // What moved beyond the outline of before is a sliver.
      const int cell = before.division.cell_at(labelled.division.inside(c));
      labelled.labels[c] = before.labels[std::max(cell, 0)];
    }
  }
  return std::nullopt;
}

}  // namespace gable
