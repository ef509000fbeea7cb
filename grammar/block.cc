#include <gable/grammar/block.h>

namespace gable {

std::vector<BlockSource> block_sources(const House& house) {
  std::vector<BlockSource> sources;
  for (int i = 0; i < house.num_components(); ++i) {
    sources.push_back({BlockRole::kComponent, i, 0, house.roof_block(i),
                       house.footprint_block(house.footprint_of_component(i))});
  }
  for (int i = 0; i < static_cast<int>(house.garages.size()); ++i) {
    const int wings = house.garages[i].kind == RuleKind::kGarageL ? 2 : 1;
    for (int wing = 0; wing < wings; ++wing) {
      sources.push_back({BlockRole::kGarage, i, wing, house.garage_block(i), -1});
    }
  }
  for (int i = 0; i < static_cast<int>(house.dormers.size()); ++i) {
    const int component = house.dormers[i].component;
    sources.push_back({BlockRole::kDormer, i, 0, house.dormer_block(i),
                       house.footprint_block(house.footprint_of_component(component))});
  }
  for (int i = 0; i < static_cast<int>(house.chimneys.size()); ++i) {
    sources.push_back({BlockRole::kChimney, i, 0, house.chimney_block(i), -1});
  }
  return sources;
}

std::vector<Block<double>> expand_blocks(const House& house) {
  const auto rules = house.derivation();
  std::vector<Block<double>> blocks;
  for (const BlockSource& source : block_sources(house)) {
    const double* footprint =
        source.footprint_rule < 0 ? nullptr : rules[source.footprint_rule]->values.data();
    blocks.push_back(
        expand_block<double>(house, source, rules[source.own_rule]->values.data(), footprint));
  }
  return blocks;
}

}  // namespace gable
