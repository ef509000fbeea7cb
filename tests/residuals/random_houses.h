#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>
#include <gable/residuals/height_image.h>

#include <vector>

namespace gable {

// An image of heights without any house in it, over uneven ground, with holes.
inline HeightImage noisy_image(uint64_t seed) {
  Random random(seed);
  HeightImage image;
  image.rows = 40;
  image.cols = 44;
  image.gsd = 0.5;
  image.first_center = {-11.0, 10.0};
  for (size_t i = 0; i < image.size(); ++i) {
    image.height.push_back(static_cast<float>(random.uniform(0.0, 8.0)));
    image.ground.push_back(static_cast<float>(random.uniform(-0.3, 0.3)));
    image.weight.push_back(random.chance(0.1) ? 0.0f : 1.0f);
  }
  return image;
}

// A house with every kind of rule of its foundation, at random values.
inline House rich_house(Foundation foundation, Random* random) {
  House house = make_house(foundation);
  house.azimuth[0] = random->uniform(-3.0, 3.0);
  for (Rule& f : house.footprints) {
    for (double& v : f.parameters()) v += random->uniform(-2.0, 2.0);
    if (f.kind != RuleKind::kFootprintI) f[0] -= 6.0, f[1] -= 6.0;
  }
  for (Rule& roof : house.roofs) {
    const Axis ridge = random->chance(0.5) ? Axis::kX : Axis::kY;
    roof = make_rule(
        static_cast<RuleKind>(static_cast<int>(RuleKind::kRoofFlat) + random->integer(0, 3)));
    roof.ridge = ridge;
    roof[0] = random->uniform(3.0, 5.0);
    roof[1] = random->uniform(1.0, 4.0);
    roof[2] = random->uniform(0.05, 0.45);
    roof[3] = random->uniform(0.05, 0.45);
    if (roof.kind == RuleKind::kRoofMansard) roof[2] += 0.5;
  }
  for (int k = 0; k < 2; ++k) {
    Rule dormer = make_rule(RuleKind::kDormer);
    dormer.component = random->integer(0, house.num_components() - 1);
    dormer.values = {random->uniform(-4.0, 4.0), random->uniform(-3.0, 3.0),
                     random->uniform(1.5, 3.0),  random->uniform(1.5, 3.0),
                     random->uniform(5.0, 7.0),  random->uniform(0.3, 1.0)};
    house.dormers.push_back(dormer);
    Rule chimney = make_rule(RuleKind::kChimney);
    chimney.values = {random->uniform(-4.0, 4.0), random->uniform(-4.0, 4.0),
                      random->uniform(0.6, 1.5), random->uniform(7.0, 9.0)};
    house.chimneys.push_back(chimney);
  }
  Rule garage_i = make_rule(RuleKind::kGarageI);
  garage_i.values = {random->uniform(4.0, 7.0), 0.0, 6.0, 3.0, 2.7};
  house.garages.push_back(garage_i);
  Rule garage_l = make_rule(RuleKind::kGarageL);
  garage_l.values = {-8.0, random->uniform(2.0, 5.0), 5.0, 2.0, 4.5, 2.2, 2.5};
  house.garages.push_back(garage_l);
  return house;
}

inline constexpr Foundation kAllFoundations[] = {Foundation::kI,   Foundation::kII,
                                                 Foundation::kIII, Foundation::kL,
                                                 Foundation::kU,   Foundation::kMany};

// The parameter blocks of a house as cost functions take them.
inline std::vector<const double*> pointers(const House& house) {
  std::vector<const double*> out;
  for (const Rule* rule : house.derivation()) out.push_back(rule->values.data());
  return out;
}

}  // namespace gable
