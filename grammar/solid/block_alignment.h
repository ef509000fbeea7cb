#pragma once

#include <gable/grammar/block.h>
#include <gable/grammar/solid/extrusion.h>

#include <vector>

namespace gable {

/// How the aligned blocks are moved away from a configuration that has features too fine to build.
struct Shake {
  enum class Scope {
    kNothing,
    kLevels,  ///< edges that coincide move together
    kBlocks,  ///< every block's edges move on their own
  };
  Scope scope = Scope::kNothing;
  double amplitude = 0.0;  ///< largest movement of a coordinate or a height, metres
  uint64_t seed = 0;
};

/// What to move in an attempt to build valid solids: nothing at first (attempt 0), then by turns
/// coincident edges together and every edge on its own, by 4 mm and 1 mm more each time.
Shake shake_of_attempt(int attempt);

/// Blocks whose nearly coincident edges and heights are made equal, so that no wall, step or gap
/// is finer than can be built: coordinates within 2 cm of an edge or ridge of an earlier block take
/// its value, heights within 1 cm likewise. Hips shorter than 5 cm become gables, ridges shorter
/// than 5 cm vanish, roofs that rise less than 1 cm become flat, a mansard's sides break 5 cm or
/// more from the eaves.
class BlockAlignment {
 public:
  /// `base`: height of the ground face, which counts as a height to align with.
  BlockAlignment(const std::vector<Block<double>>& blocks, double base);

  /// Whether a block keeps a length and a width after alignment.
  bool has_area(int block) const;

  /// The aligned blocks, moved by `shake`. Deterministic.
  std::vector<Block<double>> blocks(const Shake& shake = {}) const;

  /// An outline in the frame of the blocks: coordinates within 2 cm of an edge or ridge take its
  /// value, and move with it where coincident edges move together.
  PlanPolygon outline(PlanPolygon polygon, const Shake& shake = {}) const;

 private:
  // A coordinate shared by edges; ridges and breaks stand at a share of the way between two earlier
  // levels.
  struct Level {
    double value;
    int low = -1, high = -1;
    double share = 0.0;
  };
  struct AlignedBlock {
    Block<double> shape;  // axis, kind, hips or break; the rest comes from the levels
    int edges[4];         // x0, x1, y0, y1
    int eaves, ridge;
  };

  static int level_at(double value, double tolerance, std::vector<Level>* levels);
  static void add_derived(int low, int high, double share, std::vector<Level>* levels);
  static std::vector<double> shaken(const std::vector<Level>& levels, const Shake& shake,
                                    uint64_t stream);

  std::vector<Level> x_, y_, heights_;
  std::vector<AlignedBlock> aligned_;
};

}  // namespace gable
