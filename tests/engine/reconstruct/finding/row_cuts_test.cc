#include <gable/engine/reconstruct/finding/row_cuts.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <opencv2/imgproc.hpp>
#include <set>
#include <vector>

namespace gable {
namespace {

/// Heights of pixels of 0.5 m over level ground; 0: outside.
HeightImage image_of(int rows, int cols,
                     const std::function<double(const Eigen::Vector2d&)>& height) {
  HeightImage image;
  image.rows = rows;
  image.cols = cols;
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const double z = height(image.center_of(row, col));
      image.height.push_back(static_cast<float>(z));
      image.ground.push_back(0.0f);
      image.weight.push_back(1.0f);
      image.inside.push_back(z > 0.0);
    }
  }
  return image;
}

std::map<int, std::vector<size_t>> pieces_of(const std::vector<int>& piece) {
  std::map<int, std::vector<size_t>> pieces;
  for (size_t i = 0; i < piece.size(); ++i) {
    if (piece[i] >= 0) pieces[piece[i]].push_back(i);
  }
  return pieces;
}

/// Share of the pixels whose piece is that which holds most of what they truly belong to.
double share_right(const std::vector<int>& piece, const std::vector<int>& truth) {
  std::map<int, std::map<int, int>> counts;
  int all = 0, right = 0;
  for (size_t i = 0; i < piece.size(); ++i) {
    if (piece[i] < 0) continue;
    ++counts[truth[i]][piece[i]];
    ++all;
  }
  for (const auto& [house, of] : counts) {
    right += std::max_element(of.begin(), of.end(), [](const auto& a, const auto& b) {
               return a.second < b.second;
             })->second;
  }
  return static_cast<double>(right) / all;
}

TEST(RowCuts, APieceThatIsNoLargerThanAHouseIsLeftWhole) {
  // 16 m x 18 m, the step of a row in its middle.
  const HeightImage image = image_of(40, 60, [](const Eigen::Vector2d& p) {
    return p.x() > 2 && p.x() < 18 && -p.y() > 1 && -p.y() < 19 ? (p.x() < 10 ? 4.0 : 7.0) : 0.0;
  });
  const std::vector<int> piece = cut_rows(image, {}).piece;
  for (size_t i = 0; i < piece.size(); ++i) EXPECT_EQ(piece[i], image.inside[i] ? 0 : -1);
}

TEST(RowCuts, AHallUnderOneRoofIsOneBuildingWhateverItsSize) {
  const auto gable = [](const Eigen::Vector2d& p) {
    if (p.x() < 2 || p.x() > 62 || -p.y() < 2 || -p.y() > 26) return 0.0;
    return 6.0 + 0.5 * (12.0 - std::abs(-p.y() - 14.0));
  };
  const std::vector<int> piece = cut_rows(image_of(60, 130, gable), {}).piece;
  EXPECT_EQ(*std::max_element(piece.begin(), piece.end()), 0);
}

// Houses of 8 m x 10 m in a row at 20 degrees, every second one 1.2 m higher.
class SteppedRow : public testing::TestWithParam<double> {
 protected:
  static constexpr int kHouses = 8;
  static constexpr double kWidth = 8.0, kDepth = 10.0;

  HeightImage row() const {
    return image_of(110, 150, [this](const Eigen::Vector2d& p) {
      const int k = house_at(p);
      return k < 0 ? 0.0 : 6.0 + 1.2 * (k % 2) - 0.4 * std::abs(along(p).y() - 0.5 * kDepth);
    });
  }
  std::vector<int> truth(const HeightImage& image) const {
    std::vector<int> house;
    for (int r = 0; r < image.rows; ++r) {
      for (int c = 0; c < image.cols; ++c) house.push_back(house_at(image.center_of(r, c)));
    }
    return house;
  }

 private:
  Eigen::Vector2d along(const Eigen::Vector2d& p) const {
    const double a = GetParam();
    const Eigen::Vector2d d = p - Eigen::Vector2d(4.0, -40.0);
    return {std::cos(a) * d.x() + std::sin(a) * d.y(), -std::sin(a) * d.x() + std::cos(a) * d.y()};
  }
  int house_at(const Eigen::Vector2d& p) const {
    const Eigen::Vector2d q = along(p);
    if (q.x() < 0 || q.x() >= kHouses * kWidth || q.y() < 0 || q.y() >= kDepth) return -1;
    return static_cast<int>(q.x() / kWidth);
  }
};

TEST_P(SteppedRow, IsCutAtItsPartyWalls) {
  const HeightImage image = row();
  RowCutOptions options;
  options.most_area = 120.0;
  const std::vector<int> piece = cut_rows(image, options).piece;
  EXPECT_EQ(pieces_of(piece).size(), 8u);
  EXPECT_GT(share_right(piece, truth(image)), 0.95);
}

TEST_P(SteppedRow, NoPieceIsLargerThanAsked) {
  const HeightImage image = row();
  const auto pieces = pieces_of(cut_rows(image, {}).piece);
  EXPECT_GT(pieces.size(), 3u);
  for (const auto& [number, pixels] : pieces) EXPECT_LE(pixels.size() * 0.25, 150.0);
}

TEST_P(SteppedRow, PiecesFillTheirSmallestRectangles) {
  // Cuts across the axes would leave triangles.
  const HeightImage image = row();
  for (const auto& [number, pixels] : pieces_of(cut_rows(image, {}).piece)) {
    std::vector<cv::Point2f> points;
    for (const size_t i : pixels) {
      const int r = static_cast<int>(i) / image.cols, c = static_cast<int>(i) % image.cols;
      const Eigen::Vector2d p = image.center_of(r, c);
      points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
    }
    const cv::Size2f size = cv::minAreaRect(points).size;
    EXPECT_GT(pixels.size() * 0.25, 0.85 * (size.width + 0.5) * (size.height + 0.5));
  }
}

TEST_P(SteppedRow, PiecesLieOnTheNegativeSidesOfTheirCuts) {
  const HeightImage image = row();
  const RowPieces pieces = cut_rows(image, {});
  size_t num_cuts = 0;
  for (const auto& [number, pixels] : pieces_of(pieces.piece)) {
    num_cuts += pieces.cuts[number].size();
    for (const PlanLine& cut : pieces.cuts[number]) {
      for (const size_t i : pixels) {
        const int r = static_cast<int>(i) / image.cols, c = static_cast<int>(i) % image.cols;
        EXPECT_LE(cut.signed_distance(image.center_of(r, c)), 0.0);
      }
    }
  }
  // Each of the cuts that make n pieces of one divides two of them at least.
  EXPECT_GE(num_cuts, 2 * (pieces.cuts.size() - 1));
}

TEST_P(SteppedRow, PiecesBesideEachOtherHaveACutInCommonTurnedRound) {
  const HeightImage image = row();
  const RowPieces pieces = cut_rows(image, {});
  const auto divided = [&](int a, int b) {
    for (const PlanLine& cut : pieces.cuts[a]) {
      for (const PlanLine& other : pieces.cuts[b]) {
        if (cut.normal == -other.normal && cut.offset == -other.offset) return true;
      }
    }
    return false;
  };
  for (size_t i = 0; i + 1 < image.size(); ++i) {
    const int a = pieces.piece[i], b = pieces.piece[i + 1];
    if (a < 0 || b < 0 || a == b) continue;
    EXPECT_TRUE(divided(a, b)) << a << " " << b;
  }
}

INSTANTIATE_TEST_SUITE_P(Azimuths, SteppedRow, testing::Values(0.0, 0.2, 0.35, 0.5));

TEST(RowCuts, GablesSideBySideAreCutInTheirValleys) {
  // Five gables of 8 m, ridges across the row: no steps at all.
  const auto saw = [](const Eigen::Vector2d& p) {
    const double x = p.x() - 2.0, y = -p.y() - 2.0;
    if (x < 0 || x >= 40 || y < 0 || y >= 14) return 0.0;
    return 8.0 - 0.9 * std::abs(std::fmod(x, 8.0) - 4.0);
  };
  const HeightImage image = image_of(36, 90, saw);
  RowCutOptions options;
  options.most_area = 130.0;
  const std::vector<int> piece = cut_rows(image, options).piece;
  std::vector<int> truth;
  for (int r = 0; r < image.rows; ++r) {
    for (int c = 0; c < image.cols; ++c) {
      truth.push_back(static_cast<int>((image.center_of(r, c).x() - 2.0) / 8.0));
    }
  }
  EXPECT_EQ(pieces_of(piece).size(), 5u);
  EXPECT_GT(share_right(piece, truth), 0.93);
}

TEST(RowCuts, PiecesHangTogetherAndNoneIsACrumb) {
  // A comb: a row with narrow teeth of 6 square metres, which no cut may leave alone.
  const auto comb = [](const Eigen::Vector2d& p) {
    const double x = p.x() - 2.0, y = -p.y() - 2.0;
    if (x < 0 || x >= 60 || y < 0) return 0.0;
    if (y < 9) return std::fmod(x, 20.0) < 10.0 ? 6.0 : 7.5;
    return y < 12 && std::fmod(x, 6.0) < 2.0 ? 3.0 : 0.0;
  };
  const HeightImage image = image_of(34, 130, comb);
  const RowCutOptions options;
  for (const auto& [number, pixels] : pieces_of(cut_rows(image, options).piece)) {
    EXPECT_GE(pixels.size() * 0.25, options.least_part);
    const std::set<size_t> own(pixels.begin(), pixels.end());
    std::set<size_t> reached = {pixels.front()};
    std::vector<size_t> open = {pixels.front()};
    while (!open.empty()) {
      const size_t i = open.back();
      open.pop_back();
      for (const size_t j : {i - 1, i + 1, i - image.cols, i + image.cols}) {
        if (own.count(j) && reached.insert(j).second) open.push_back(j);
      }
    }
    EXPECT_EQ(reached.size(), pixels.size());
  }
}

TEST(RowCuts, AnImageWithNothingInsideHasNoPieces) {
  const HeightImage image = image_of(5, 5, [](const Eigen::Vector2d&) { return 0.0; });
  EXPECT_EQ(cut_rows(image, {}).piece, std::vector<int>(25, -1));
}

TEST(RowCuts, OptionsOutOfRangeAreNamed) {
  EXPECT_EQ(check(RowCutOptions{}), "");
  EXPECT_NE(check(RowCutOptions{.least_row = 1.0}).find("least_row"), std::string::npos);
  EXPECT_NE(check(RowCutOptions{.most_area = 1.0}).find("most_area"), std::string::npos);
  EXPECT_NE(check(RowCutOptions{.least_part = -1.0}).find("least_part"), std::string::npos);
  EXPECT_NE(check(RowCutOptions{.step = 0.0}).find("step"), std::string::npos);
  EXPECT_NE(check(RowCutOptions{.seam_price = 2.0}).find("seam_price"), std::string::npos);
  EXPECT_NE(check(RowCutOptions{.fill = 0.0}).find("fill"), std::string::npos);
  EXPECT_NE(check(RowCutOptions{.oblique_price = -1.0}).find("oblique_price"), std::string::npos);
  EXPECT_NE(check(RowCutOptions{.seams = -0.1}).find("seams"), std::string::npos);
  EXPECT_NE(check(RowCutOptions{.directions = 1}).find("directions"), std::string::npos);
}

}  // namespace
}  // namespace gable
