#include <gable/engine/reconstruct/neighbours/neighbour_groups.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gable {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Groups = std::vector<std::vector<int>>;

std::vector<NeighbourRelation> walls(const std::vector<std::pair<int, int>>& pairs) {
  std::vector<NeighbourRelation> relations;
  for (const auto& [a, b] : pairs) {
    relations.push_back({NeighbourRelationKind::kPartyWall, a, b, {}, {}});
  }
  return relations;
}

TEST(NeighbourGroups, AreWhatPartyWallsConnect) {
  auto relations = walls({{4, 1}, {1, 3}, {0, 5}});
  relations.push_back({NeighbourRelationKind::kEqualEaves, 2, 3, {}, {}});
  EXPECT_THAT(neighbour_groups(7, relations, 40),
              ElementsAre(ElementsAre(0, 5), ElementsAre(3, 1, 4)));
  EXPECT_THAT(neighbour_groups(3, {}, 40), IsEmpty());
}

TEST(NeighbourGroups, LongRowsAreCutFromOneEnd) {
  // 0 stands in the middle: 3 - 1 - 0 - 2 - 4.
  const auto relations = walls({{0, 1}, {0, 2}, {1, 3}, {2, 4}});
  EXPECT_THAT(neighbour_groups(5, relations, 2), ElementsAre(ElementsAre(3, 1), ElementsAre(0, 2)));
  EXPECT_THAT(neighbour_groups(5, relations, 3),
              ElementsAre(ElementsAre(3, 1, 0), ElementsAre(2, 4)));
}

}  // namespace
}  // namespace gable
