#include <gable/engine/reconstruct/first_values/block_search.h>
#include <gable/engine/reconstruct/heights/rectified_view.h>
#include <gable/grammar/block.h>
#include <gable/residuals/robust_loss.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/house_image.h"

namespace gable {
namespace {

using Edges = std::array<double, 4>;  // x0, x1, y0, y1

// The components' edges in the house frame of azimuth `azimuth`, a whole number of quarter turns
// from the house's own.
std::vector<Edges> edges_in(const House& house, double azimuth) {
  using namespace block_value;
  const HeightField field(house);
  const double c = std::cos(azimuth), s = std::sin(azimuth);
  std::vector<Edges> out;
  for (int i = 0; i < house.num_components(); ++i) {
    const Block<double>& b = field.blocks()[i];
    const Eigen::Vector2d p = field.local_from_house({b[kX0], b[kY0]});
    const Eigen::Vector2d q = field.local_from_house({b[kX1], b[kY1]});
    const double px = c * p.x() + s * p.y(), qx = c * q.x() + s * q.y();
    const double py = c * p.y() - s * p.x(), qy = c * q.y() - s * q.x();
    out.push_back({std::min(px, qx), std::max(px, qx), std::min(py, qy), std::max(py, qy)});
  }
  return out;
}

// The largest distance of two houses' edges, components paired as suits best.
double edge_distance(const House& truth, const House& house) {
  const std::vector<Edges> a = edges_in(truth, truth.azimuth[0]);
  std::vector<Edges> b = edges_in(house, truth.azimuth[0]);
  std::sort(b.begin(), b.end());
  double least = 1e9;
  do {
    double largest = 0.0;
    for (size_t i = 0; i < a.size(); ++i) {
      for (int k = 0; k < 4; ++k) largest = std::max(largest, std::abs(a[i][k] - b[i][k]));
    }
    least = std::min(least, largest);
  } while (std::next_permutation(b.begin(), b.end()));
  return least;
}

// One house of each type, all of whose edges are seen and further apart than edge lines must be.
House sample_house(Foundation foundation) {
  House house = make_house(foundation);
  const Rule hip = hip_roof(5.0, 2.5, 0.3, 0.3, Axis::kX);
  switch (foundation) {
    case Foundation::kI:
      return box_house(12.0, 8.0, hip);
    case Foundation::kII:
      house.footprints = {rectangle_rule(-8.0, 2.0, -4.0, 4.0),
                          rectangle_rule(2.0, 8.0, -2.0, 3.5)};
      house.roofs = {hip, gable_roof(3.0, 1.8, Axis::kX)};
      break;
    case Foundation::kIII:
      house.footprints = {rectangle_rule(-4.0, 4.0, -4.0, 4.0),
                          rectangle_rule(4.0, 10.0, -2.5, 2.5),
                          rectangle_rule(-9.0, -4.0, -4.0, 0.5)};
      house.roofs = {hip_roof(6.0, 2.5, 0.3, 0.3, Axis::kX), gable_roof(3.0, 1.5, Axis::kX),
                     flat_roof(3.5)};
      break;
    case Foundation::kL:
      house.footprints[0].values = {-7.0, -6.0, 15.0, 6.0, 13.0, 5.0};
      house.roofs = {hip_roof(4.0, 2.0, 0.2, 0.2, Axis::kX),
                     hip_roof(4.0, 1.7, 0.2, 0.2, Axis::kY)};
      break;
    default:
      house.footprints[0].values = {-9.0, -6.0, 18.0, 6.0, 13.0, 5.0, 11.0, 5.5};
      house.roofs = {hip_roof(4.0, 2.0, 0.2, 0.2, Axis::kX), hip_roof(4.0, 1.7, 0.2, 0.2, Axis::kY),
                     hip_roof(4.0, 1.9, 0.2, 0.2, Axis::kY)};
  }
  return house;
}

class BlockSearch : public testing::TestWithParam<Foundation> {};

TEST_P(BlockSearch, FindsAHypothesisOfTheTypeWithinAMetreOfTheEdges) {
  for (const double azimuth : {0.0, 0.35, 1.1, 2.4}) {
    House truth = sample_house(GetParam());
    truth.origin = {10.0, 20.0, 3.0};
    truth.azimuth[0] = azimuth;
    const RectifiedView view = rectify(image_of(truth), std::fmod(azimuth, 0.5 * M_PI), 0.5, 1.5);
    double least = 1e9;
    for (const Hypothesis& h : search_blocks(view, truth.origin, {})) {
      ASSERT_TRUE(is_well_formed(h.house));
      EXPECT_EQ(h.house.origin, truth.origin);
      if (h.house.foundation == GetParam()) least = std::min(least, edge_distance(truth, h.house));
    }
    EXPECT_LE(least, 1.0) << "azimuth " << azimuth;
  }
}

INSTANTIATE_TEST_SUITE_P(Foundations, BlockSearch,
                         testing::Values(Foundation::kI, Foundation::kII, Foundation::kIII,
                                         Foundation::kL, Foundation::kU),
                         [](const auto& test) { return std::string(foundation_name(test.param)); });

TEST(BlockSearchResult, HoldsAtMostSoManyOfEachTypeBestFirst) {
  const RectifiedView view = rectify(image_of(sample_house(Foundation::kU)), 0.0, 0.5, 1.5);
  for (const int count : {1, 3}) {
    BlockSearchOptions options;
    options.per_foundation = count;
    const std::vector<Hypothesis> found = search_blocks(view, Eigen::Vector3d::Zero(), options);
    for (const Foundation f :
         {Foundation::kI, Foundation::kII, Foundation::kIII, Foundation::kL, Foundation::kU}) {
      std::vector<double> gains;
      for (const Hypothesis& h : found) {
        if (h.house.foundation == f) gains.push_back(h.gain);
      }
      EXPECT_GE(gains.size(), 1u) << foundation_name(f);
      EXPECT_LE(static_cast<int>(gains.size()), count) << foundation_name(f);
      EXPECT_TRUE(std::is_sorted(gains.rbegin(), gains.rend())) << foundation_name(f);
    }
  }
}

TEST(BlockSearchResult, GainIsWhatTheEnvelopeSavesAgainstTheGround) {
  // Two flat blocks on cell boundaries leave nothing unexplained. Large overlaps are sampled: 2 %.
  House truth = make_house(Foundation::kII);
  truth.footprints = {rectangle_rule(-8.0, 2.0, -4.0, 4.0), rectangle_rule(2.0, 8.0, -4.0, 4.0)};
  truth.roofs = {flat_roof(6.0), flat_roof(4.0)};
  const HeightImage image = image_of(truth);
  const RectifiedView view = rectify(image, 0.0, 0.5, 1.5);
  const RobustLoss loss(LossKind::kSoftL1, 0.3);
  double ground = 0.0;
  for (float z : view.height) ground += loss.cost(z);
  double best = 0.0;
  for (const Hypothesis& h : search_blocks(view, Eigen::Vector3d::Zero(), {})) {
    best = std::max(best, h.gain);
    EXPECT_LE(h.gain, 1.02 * ground);
  }
  EXPECT_NEAR(best, ground, 0.02 * ground);
}

TEST(BlockSearchResult, IsEmptyWithoutABuilding) {
  EXPECT_TRUE(search_blocks(RectifiedView{}, Eigen::Vector3d::Zero(), {}).empty());
}

}  // namespace
}  // namespace gable
