#include <gable/engine/io/shapes/ring_triangles.h>

#include <algorithm>
#include <limits>

namespace gable {
namespace {

using Point = Eigen::Vector2d;

/// Twice the signed area of a triangle.
double cross(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool in_triangle(const Point& p, const Point& a, const Point& b, const Point& c) {
  return cross(a, b, p) >= 0.0 && cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0;
}

/// A corner of a closed loop; where a bridge starts, a point has several.
struct Corner {
  int point;
  Point at;
  int before, after;
};

class Loops {
 public:
  /// Adds a ring and returns one of its corners.
  int add(const std::vector<Point>& ring) {
    const int first = static_cast<int>(corners_.size());
    const int size = static_cast<int>(ring.size());
    for (int i = 0; i < size; ++i) {
      corners_.push_back(
          {first + i, ring[i], first + (i + size - 1) % size, first + (i + 1) % size});
    }
    return first;
  }

  const Corner& operator[](int i) const { return corners_[i]; }

  /// The corner of a loop furthest to the right.
  int rightmost(int loop) const {
    int best = loop;
    for (int i = corners_[loop].after; i != loop; i = corners_[i].after) {
      if (corners_[i].at.x() > corners_[best].at.x()) best = i;
    }
    return best;
  }

  /// Makes one loop of two, by a bridge there and back.
  void join(int outer, int hole) {
    const int outer_copy = copy(outer), hole_copy = copy(hole);
    const int after = corners_[outer].after, before = corners_[hole].before;
    link(outer, hole);
    link(before, hole_copy);
    link(hole_copy, outer_copy);
    link(outer_copy, after);
  }

  void remove(int i) { link(corners_[i].before, corners_[i].after); }

  bool is_reflex(int i) const {
    const Corner& c = corners_[i];
    return !(cross(corners_[c.before].at, c.at, corners_[c.after].at) > 0.0);
  }

  /// Whether a point lies in the inner angle at a corner; tells the corners of a point apart.
  bool sees(int i, const Point& p) const {
    const Point &a = corners_[corners_[i].before].at, &b = corners_[i].at,
                &c = corners_[corners_[i].after].at;
    const bool left_of_first = cross(a, b, p) > 0.0, left_of_second = cross(b, c, p) > 0.0;
    return is_reflex(i) ? left_of_first || left_of_second : left_of_first && left_of_second;
  }

  /// The corner of a loop around `from` that a bridge from there may lead to: the ray to the right
  /// first meets an edge; what can be seen is the end of that edge, or a reflex corner before it.
  int visible(int loop, const Point& from) const {
    double nearest = std::numeric_limits<double>::infinity();
    int best = -1;
    int i = loop;
    do {
      const Point &a = corners_[i].at, &b = corners_[corners_[i].after].at;
      if (a.y() <= from.y() && b.y() >= from.y() && a.y() != b.y()) {
        const double x = a.x() + (from.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        if (x >= from.x() && x < nearest) {
          nearest = x;
          best = a.x() > b.x() ? i : corners_[i].after;
        }
      }
      i = corners_[i].after;
    } while (i != loop);
    if (best < 0) return loop;  // not inside: any bridge is as bad

    const Point hit(nearest, from.y()), end = corners_[best].at;
    const bool above = end.y() > from.y();
    double flattest = std::numeric_limits<double>::infinity();
    int chosen = -1;
    i = loop;
    do {
      const Point& p = corners_[i].at;
      const bool inside = above ? in_triangle(p, from, hit, end) : in_triangle(p, from, end, hit);
      if ((inside || p == end) && p.x() >= from.x() && sees(i, from)) {
        const double slope = std::abs(p.y() - from.y()) / std::max(p.x() - from.x(), 1e-300);
        const bool closer = chosen >= 0 && slope == flattest && p.x() < corners_[chosen].at.x();
        if (slope < flattest || closer) flattest = slope, chosen = i;
      }
      i = corners_[i].after;
    } while (i != loop);
    return chosen >= 0 ? chosen : best;
  }

  /// Whether a corner is convex and its triangle holds none of the given corners.
  bool is_ear(int i, const std::vector<int>& reflex) const {
    if (is_reflex(i)) return false;
    const Point &a = corners_[corners_[i].before].at, &b = corners_[i].at,
                &c = corners_[corners_[i].after].at;
    return std::none_of(reflex.begin(), reflex.end(), [&](int other) {
      const Point& p = corners_[other].at;
      return p != a && p != b && p != c && in_triangle(p, a, b, c);
    });
  }

 private:
  int copy(int i) {
    corners_.push_back(corners_[i]);
    return static_cast<int>(corners_.size()) - 1;
  }
  void link(int a, int b) {
    corners_[a].after = b;
    corners_[b].before = a;
  }

  std::vector<Corner> corners_;
};

std::vector<std::array<int, 3>> clip_ears(Loops* loops, int first) {
  std::vector<int> reflex;
  int size = 0;
  int i = first;
  do {
    if (loops->is_reflex(i)) reflex.push_back(i);
    ++size;
    i = (*loops)[i].after;
  } while (i != first);

  std::vector<std::array<int, 3>> triangles;
  int tried = 0;
  while (size >= 3) {
    // Rings that cross themselves may have no ear: then any corner goes.
    if (size > 3 && tried < size && !loops->is_ear(i, reflex)) {
      i = (*loops)[i].after;
      ++tried;
      continue;
    }
    const int before = (*loops)[i].before, after = (*loops)[i].after;
    triangles.push_back({(*loops)[before].point, (*loops)[i].point, (*loops)[after].point});
    loops->remove(i);
    --size;
    tried = 0;
    // Corners only turn convex, never reflex, as long as ears go.
    std::erase_if(reflex, [&](int other) {
      return other == i || ((other == before || other == after) && !loops->is_reflex(other));
    });
    i = (*loops)[after].after;  // not the next, which would make a fan of slivers
  }
  return triangles;
}

}  // namespace

std::vector<std::array<int, 3>> triangulate_rings(
    const std::vector<std::vector<Eigen::Vector2d>>& rings) {
  Loops loops;
  const int outer = loops.add(rings[0]);
  std::vector<int> holes;
  for (size_t i = 1; i < rings.size(); ++i) holes.push_back(loops.rightmost(loops.add(rings[i])));
  std::stable_sort(holes.begin(), holes.end(),
                   [&](int a, int b) { return loops[a].at.x() > loops[b].at.x(); });
  for (const int hole : holes) loops.join(loops.visible(outer, loops[hole].at), hole);
  return clip_ears(&loops, outer);
}

}  // namespace gable
