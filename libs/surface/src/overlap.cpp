
#include "depth.hpp"
#include "parallel_blocks.hpp"
#include "plane_triangles.hpp"

#include <isostretch/core/index.hpp>
#include <isostretch/surface/overlap.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace isostretch::mesh {
namespace {

constexpr int block_size = 512;

struct Segment {
  PlanePoint from{}, to{};
};

Segment edge(const PlaneTriangle& triangle, std::size_t e) {
  return {triangle.corner[e], triangle.corner[(e + 1) % 3]};
}

Segment ascending(Segment s) {
  if (s.to < s.from) std::swap(s.from, s.to);
  return s;
}

// Where two lines cross of which each has an end of the other's segment on either side, or on it. Both
// segments find the same point, to the bit, in whatever direction they run.
PlanePoint crossing(Segment a, Segment b) {
  a = ascending(a);
  b = ascending(b);
  if (std::pair(b.from, b.to) < std::pair(a.from, a.to)) std::swap(a, b);
  for (const auto& [line, segment] : {std::pair{&a, &b}, std::pair{&b, &a}})
    for (const PlanePoint* end : {&segment->from, &segment->to})
      if (side(line->from, line->to, *end) == 0) return *end;
  const double before = doubled_area(b.from, b.to, a.from), after = doubled_area(b.from, b.to, a.to);
  const double t = before / (before - after);
  return {a.from[0] + t * (a.to[0] - a.from[0]), a.from[1] + t * (a.to[1] - a.from[1])};
}

bool same_direction(const Segment& a, const Segment& b) {
  return (a.to[0] - a.from[0]) * (b.to[0] - b.from[0]) + (a.to[1] - a.from[1]) * (b.to[1] - b.from[1]) > 0;
}

Interval whole(const Segment& s) {
  return {{0, s.from}, {1, s.to}};
}

// What part of the segment lies under the triangle. An edge that runs along one of the triangle's lies under
// it or not, whichever is asked for: of edges that coincide each is then under those before it.
std::optional<Interval> interval_under(const PlaneTriangle& triangle, const Segment& s, bool when_along) {
  Interval under = whole(s);
  for (std::size_t e = 0; e < 3; ++e) {
    const Segment line = edge(triangle, e);
    const double from = doubled_area(line.from, line.to, s.from), to = doubled_area(line.from, line.to, s.to);
    if (from == 0 && to == 0 && when_along && same_direction(line, s)) continue;
    if (from <= 0 && to <= 0) return {};
    if (from >= 0 && to >= 0) continue;
    const double along = from / (from - to);
    Mark& bound = from < 0 ? under.begin : under.end;
    if (from < 0 ? along > bound.along : along < bound.along) bound = Mark{along, crossing(s, line)};
  }
  if (!(under.begin.along < under.end.along)) return {};
  return under;
}

// The triangles of a plane, to be asked which others overlap one.
class Neighbours {
 public:
  explicit Neighbours(const std::vector<PlaneTriangle>& triangles)
      : triangles_(triangles), boxes_(boxes_of(triangles)), tree_(boxes_) {}

  // Calls visit(j) for those that overlap triangle i and meet the box, which may shrink meanwhile, ascending,
  // until it returns false.
  template <class Visit>
  void visit(int i, const PlaneBox& box, const Visit& visit) const {
    tree_.query(box, [&](int j) {
      return i == j || !interiors_meet(triangles_[at(i)], triangles_[at(j)]) || visit(j);
    });
  }
  template <class Visit>
  void visit(int i, const Visit& each) const {
    visit(i, boxes_[at(i)], each);
  }

 private:
  static std::vector<PlaneBox> boxes_of(const std::vector<PlaneTriangle>& triangles) {
    std::vector<PlaneBox> boxes;
    boxes.reserve(triangles.size());
    for (const PlaneTriangle& t : triangles) boxes.push_back(t.box());
    return boxes;
  }

  const std::vector<PlaneTriangle>& triangles_;
  std::vector<PlaneBox> boxes_;
  BoxTree tree_;
};

// Where almost equal triangles lie on each other, both ends of an edge stick out and its middle does not: a
// box around one end is small, a box around both is that of the edge.
std::array<Interval, 2> halves(const Segment& s) {
  const auto [begin, end] = whole(s);
  const Mark middle{0.5, {0.5 * (s.from[0] + s.to[0]), 0.5 * (s.from[1] + s.to[1])}};
  return {Interval{begin, middle}, Interval{middle, end}};
}

// Areas by how many triangles lie there, as integrals over the edges. Along an edge under `depth` others a
// region of that many triangles becomes one of more.
class Measure {
 public:
  Measure(const std::vector<PlaneTriangle>& triangles, const Neighbours& neighbours)
      : triangles_(triangles), neighbours_(neighbours) {
    if (triangles.empty()) return;
    PlaneBox whole = triangles.front().box();
    for (const PlaneTriangle& t : triangles) whole.include(t.box());
    for (std::size_t d = 0; d < 2; ++d) origin_[d] = 0.5 * (whole.low[d] + whole.high[d]);
  }

  // What one triangle contributes to areas and to the list of those that overlap.
  void add(int i, Overlap& overlap) const {
    const PlaneTriangle& triangle = triangles_[at(i)];
    std::vector<int> few;
    neighbours_.visit(i, [&](int j) {
      few.push_back(j);
      return few.size() <= many;
    });
    if (few.empty() && triangle.copies.size() == 1) {
      overlap.covered_area += 0.5 * doubled_area(triangle.corner[0], triangle.corner[1], triangle.corner[2]);
      return;
    }
    overlap.triangles.insert(overlap.triangles.end(), triangle.copies.begin(), triangle.copies.end());
    for (std::size_t e = 0; e < 3; ++e) {
      const Segment s = edge(triangle, e);
      if (few.size() <= many)
        integrate(under_few(i, s, few), triangle.copy_count(), overlap);
      else
        for (const Interval& half : halves(s))
          integrate(under_many(i, s, half), triangle.copy_count(), overlap);
    }
  }

 private:
  static constexpr std::size_t many = 32;

  Depth under_few(int i, const Segment& s, const std::vector<int>& others) const {
    Depth depth(whole(s));
    for (const int j : others) add_under(i, s, j, depth);
    depth.join();
    return depth;
  }

  // Looks for them where that still matters.
  Depth under_many(int i, const Segment& s, const Interval& half) const {
    Depth depth(half);
    neighbours_.visit(i, depth.open(), [&](int j) {
      add_under(i, s, j, depth);
      return true;
    });
    depth.join();
    return depth;
  }

  void add_under(int i, const Segment& s, int j, Depth& depth) const {
    const PlaneTriangle& above = triangles_[at(j)];
    if (const auto under = interval_under(above, s, j < i)) depth.add(*under, above.copy_count());
  }

  void integrate(const Depth& under, double copies, Overlap& overlap) const {
    under.for_each_part([&](const PlanePoint& from, const PlanePoint& to, double depth) {
      const double area =
          0.5 * ((from[0] - origin_[0]) * (to[1] - from[1]) - (from[1] - origin_[1]) * (to[0] - from[0]));
      if (depth < 1) overlap.covered_area += area;
      if (depth < 2 && depth + copies >= 2) overlap.overlapped_area += area;
    });
  }

  const std::vector<PlaneTriangle>& triangles_;
  const Neighbours& neighbours_;
  PlanePoint origin_{};
};

std::size_t block_count(const std::vector<PlaneTriangle>& triangles) {
  return triangles.size() / block_size + 1;
}

}  // namespace

Overlap find_overlap(const Points2& uv, const Triangles& triangles) {
  const PlaneTriangles plane(uv, triangles);
  const Neighbours neighbours(plane.triangles);
  const Measure measure(plane.triangles, neighbours);
  std::vector<Overlap> found(block_count(plane.triangles));
  for_blocks(static_cast<int>(plane.triangles.size()), block_size, [&](int begin, int end, int block) {
    for (int i = begin; i < end; ++i) measure.add(i, found[at(block)]);
  });
  Overlap overlap;
  for (const Overlap& own : found) {
    overlap.covered_area += own.covered_area;
    overlap.overlapped_area += own.overlapped_area;
    overlap.triangles.insert(overlap.triangles.end(), own.triangles.begin(), own.triangles.end());
  }
  std::sort(overlap.triangles.begin(), overlap.triangles.end());
  const double unit_area = plane.unit * plane.unit;
  overlap.covered_area *= unit_area;
  overlap.overlapped_area = std::max(0.0, overlap.overlapped_area) * unit_area;
  return overlap;
}

std::vector<std::array<int, 2>> overlapping_pairs(const Points2& uv, const Triangles& triangles) {
  const PlaneTriangles plane(uv, triangles);
  using Pairs = std::vector<std::array<int, 2>>;
  std::vector<Pairs> found(block_count(plane.triangles));
  const Neighbours neighbours(plane.triangles);
  for_blocks(static_cast<int>(plane.triangles.size()), block_size, [&](int begin, int end, int block) {
    const auto add = [&](int i, int j) {
      for (const int a : plane.triangles[at(i)].copies)
        for (const int b : plane.triangles[at(j)].copies)
          if (a < b) found[at(block)].push_back({a, b});
    };
    for (int i = begin; i < end; ++i) {
      add(i, i);
      neighbours.visit(i, [&](int j) {
        add(i, j);
        return true;
      });
    }
  });
  Pairs pairs;
  for (const Pairs& own : found) pairs.insert(pairs.end(), own.begin(), own.end());
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace isostretch::mesh
