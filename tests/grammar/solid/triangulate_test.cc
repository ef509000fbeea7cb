#include <gable/grammar/random.h>
#include <gable/grammar/solid/triangulate.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace gable {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// A solid of one face: the rings laid into a tilted plane.
Solid face_of(const std::vector<Points>& rings, const Eigen::Matrix3d& frame) {
  Solid solid;
  solid.faces.emplace_back();
  for (const Points& ring : rings) {
    std::vector<int>& indices = solid.faces[0].rings.emplace_back();
    for (const Eigen::Vector2d& p : ring) {
      indices.push_back(static_cast<int>(solid.vertices.size()));
      solid.vertices.push_back(frame * Eigen::Vector3d(p.x(), p.y(), 0.7));
    }
  }
  return solid;
}

Eigen::Matrix3d frame(double turn, double tilt) {
  return (Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

double area(const Points& ring) {
  double twice = 0.0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d &a = ring[i], &b = ring[(i + 1) % ring.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

/// The triangles' areas add up to the face's, none is turned over, and every edge inside is used
/// once each way while every edge of a ring is used once.
void expect_covers(const std::vector<Points>& rings, const Eigen::Matrix3d& plane) {
  const Solid solid = face_of(rings, plane);
  const auto triangles = triangulate(solid, solid.faces[0]);
  size_t corners = 0;
  double expected = 0.0;
  for (const Points& ring : rings) {
    corners += ring.size();
    expected += area(ring);  // holes are clockwise
  }
  EXPECT_EQ(triangles.size(), corners + 2 * (rings.size() - 1) - 2);
  const Eigen::Vector3d normal = plane.col(2);
  double sum = 0.0;
  std::map<std::pair<int, int>, int> uses;
  for (const auto& t : triangles) {
    const Eigen::Vector3d cross = (solid.vertices[t[1]] - solid.vertices[t[0]])
                                      .cross(solid.vertices[t[2]] - solid.vertices[t[0]]);
    EXPECT_GT(cross.dot(normal), -1e-9);
    sum += 0.5 * cross.norm();
    for (int k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
  }
  EXPECT_NEAR(sum, expected, 1e-9 * std::max(1.0, expected));
  for (const std::vector<int>& ring : solid.faces[0].rings) {
    for (size_t i = 0; i < ring.size(); ++i) ++uses[{ring[(i + 1) % ring.size()], ring[i]}];
  }
  for (const auto& [edge, count] : uses) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(uses.count({edge.second, edge.first}), 1u) << edge.first << " " << edge.second;
  }
}

const Points kSquare = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};

TEST(Triangulate, ConvexConcaveAndCollinearOutlinesInEveryPlane) {
  const Points ell = {{0, 0}, {8, 0}, {8, 3}, {3, 3}, {3, 9}, {0, 9}};
  const Points dotted = {{0, 0}, {3, 0}, {6, 0}, {10, 0}, {10, 5}, {10, 10}, {0, 10}, {0, 1}};
  const Points comb = {{0, 0}, {9, 0}, {9, 5}, {8, 5}, {8, 1}, {5, 1},
                       {5, 6}, {4, 6}, {4, 1}, {1, 1}, {1, 5}, {0, 5}};
  for (const double tilt : {0.0, 0.5, 1.57, 2.2, 3.14}) {
    for (const double turn : {0.0, 1.0, 4.0}) {
      for (const Points& outline : {kSquare, ell, dotted, comb}) {
        expect_covers({outline}, frame(turn, tilt));
      }
    }
  }
}

TEST(Triangulate, HolesAlsoWhenTheirCornersAlign) {
  const auto hole = [](double x, double y) {
    return Points{{x, y}, {x, y + 1}, {x + 1, y + 1}, {x + 1, y}};
  };
  expect_covers({kSquare, hole(3, 3)}, frame(0.3, 0.4));
  expect_covers({kSquare, hole(1, 1), hole(3, 1), hole(5, 1), hole(1, 3), hole(8, 8)},
                frame(0.0, 0.0));
  expect_covers({kSquare, hole(1, 1), hole(2.5, 2.5), hole(4, 4), hole(7, 1), hole(1, 7)},
                frame(1.0, 2.0));
}

TEST(Triangulate, RandomStarsWithAHole) {
  Random random(11);
  for (int trial = 0; trial < 300; ++trial) {
    const int n = random.integer(3, 30);
    Points star, hole;
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * M_PI * (i + random.uniform(0.05, 0.95)) / n;
      const double radius = random.uniform(4.0, 10.0);
      star.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    // With few corners the middle may lie outside the outline.
    if (n < 12) {
      expect_covers({star}, frame(random.uniform(0, 6), random.uniform(0, 3)));
      continue;
    }
    for (int i = 0; i < 5; ++i) {
      const double angle = -2.0 * M_PI * i / 5.0;
      hole.emplace_back(1.5 * std::cos(angle), 1.5 * std::sin(angle));
    }
    expect_covers({star, hole}, frame(random.uniform(0, 6), random.uniform(0, 3)));
  }
}

}  // namespace
}  // namespace gable
