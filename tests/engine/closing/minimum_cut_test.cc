#include <gable/engine/closing/minimum_cut.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gable {
namespace {

struct Network {
  struct Arc {
    int from, to;
    double capacity;
  };
  std::vector<double> on_sink_side, on_source_side;
  std::vector<Arc> arcs;

  double capacity(unsigned source_side) const {
    double sum = 0.0;
    for (size_t i = 0; i < on_sink_side.size(); ++i) {
      sum += source_side >> i & 1u ? on_source_side[i] : on_sink_side[i];
    }
    for (const Arc& arc : arcs) {
      if ((source_side >> arc.from & 1u) && !(source_side >> arc.to & 1u)) sum += arc.capacity;
    }
    return sum;
  }
};

// Whole capacities, so that there are ties and nodes that may be on either side.
Network random_network(uint64_t seed, int num_nodes) {
  Random random(seed);
  const auto whole = [&random](double up_to) { return std::floor(random.uniform(0.0, up_to)); };
  Network network;
  for (int i = 0; i < num_nodes; ++i) {
    network.on_sink_side.push_back(whole(4.0));
    network.on_source_side.push_back(whole(4.0));
  }
  for (int k = 0; k < 3 * num_nodes; ++k) {
    const int from = static_cast<int>(whole(num_nodes)), to = static_cast<int>(whole(num_nodes));
    if (from != to) network.arcs.push_back({from, to, whole(4.0)});
  }
  return network;
}

TEST(MinimumCut, IsTheLeastOfAllCuts) {
  for (uint64_t seed = 0; seed < 300; ++seed) {
    const int num_nodes = 2 + static_cast<int>(seed % 8);
    const Network network = random_network(seed, num_nodes);
    MinimumCut cut(num_nodes);
    for (int i = 0; i < num_nodes; ++i) {
      cut.add_terminals(i, network.on_sink_side[i], network.on_source_side[i]);
    }
    for (const Network::Arc& arc : network.arcs) cut.add_arc(arc.from, arc.to, arc.capacity);
    const double found = cut.solve();
    double least = std::numeric_limits<double>::infinity();
    for (unsigned side = 0; side < 1u << num_nodes; ++side) {
      least = std::min(least, network.capacity(side));
    }
    unsigned side = 0;
    for (int i = 0; i < num_nodes; ++i) side |= cut.on_source_side(i) ? 1u << i : 0u;
    EXPECT_NEAR(found, least, 1e-9) << "seed " << seed;
    EXPECT_NEAR(network.capacity(side), least, 1e-9) << "seed " << seed;
  }
}

TEST(MinimumCut, NodesWithoutArcsGoWhereTheyCostLess) {
  MinimumCut cut(2);
  cut.add_terminals(0, 3.0, 1.0);
  cut.add_terminals(1, 1.0, 3.0);
  EXPECT_DOUBLE_EQ(cut.solve(), 2.0);
  EXPECT_TRUE(cut.on_source_side(0));
  EXPECT_FALSE(cut.on_source_side(1));
}

}  // namespace
}  // namespace gable
