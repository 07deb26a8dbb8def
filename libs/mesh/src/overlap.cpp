#include <isostretch/mesh/overlap.hpp>

#include "index.hpp"
#include "parallel_blocks.hpp"
#include "plane_triangles.hpp"

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

// A place on a segment.
struct Mark {
  double along = 0;  // from 0 to 1
  PlanePoint point{};
};

// What part of the segment lies under the triangle.
struct Stretch {
  Mark begin, end;
};

bool same_direction(const Segment& a, const Segment& b) {
  return (a.to[0] - a.from[0]) * (b.to[0] - b.from[0]) + (a.to[1] - a.from[1]) * (b.to[1] - b.from[1]) > 0;
}

// An edge that runs along one of the triangle's lies under it or not, whichever is asked for: of edges that
// coincide each is then under those before it.
std::optional<Stretch> stretch_under(const PlaneTriangle& triangle, const Segment& s, bool when_along) {
  Stretch under{{0, s.from}, {1, s.to}};
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

// Areas by how many triangles lie there, as integrals over the edges. Along an edge under `depth` others a
// region of that many triangles becomes one of more.
struct Areas {
  double under_several = 0;
  double surplus = 0;  // counted once for every triangle after the first
};

struct Change {
  Mark where;
  double depth = 0;
};

class Measure {
 public:
  explicit Measure(const std::vector<PlaneTriangle>& triangles) : triangles_(triangles) {
    if (triangles.empty()) return;
    PlaneBox whole = triangles.front().box();
    for (const PlaneTriangle& t : triangles) whole.include(t.box());
    for (std::size_t d = 0; d < 2; ++d) origin_[d] = 0.5 * (whole.low[d] + whole.high[d]);
  }

  // What the edges of a triangle contribute, which lies on the others.
  Areas contribution(int triangle, const std::vector<int>& others) const {
    Areas areas;
    for (std::size_t e = 0; e < 3; ++e) integrate(triangle, edge(triangles_[at(triangle)], e), others, areas);
    return areas;
  }

 private:
  std::vector<Change> changes(int triangle, const Segment& s, const std::vector<int>& others) const {
    std::vector<Change> all;
    for (const int other : others)
      if (const auto under = stretch_under(triangles_[at(other)], s, other < triangle)) {
        all.push_back({under->begin, triangles_[at(other)].copy_count()});
        all.push_back({under->end, -triangles_[at(other)].copy_count()});
      }
    std::sort(all.begin(), all.end(),
              [](const Change& a, const Change& b) { return a.where.along < b.where.along; });
    return all;
  }

  void integrate(int triangle, const Segment& s, const std::vector<int>& others, Areas& areas) const {
    const double copies = triangles_[at(triangle)].copy_count();
    double depth = 0;
    PlanePoint from = s.from;
    const auto advance = [&](const PlanePoint& to) {
      const double area =
          0.5 * ((from[0] - origin_[0]) * (to[1] - from[1]) - (from[1] - origin_[1]) * (to[0] - from[0]));
      if (depth < 2 && depth + copies >= 2) areas.under_several += area;
      areas.surplus += (depth < 1 ? copies - 1 : copies) * area;
      from = to;
    };
    for (const Change& change : changes(triangle, s, others)) {
      advance(change.where.point);
      depth += change.depth;
    }
    advance(s.to);
  }

  const std::vector<PlaneTriangle>& triangles_;
  PlanePoint origin_{};
};

// Calls visit(i, others) with those that overlap triangle i, ascending, if there are any or it has copies.
template <class Visit>
void for_each_overlapped(const std::vector<PlaneTriangle>& triangles, const Visit& visit) {
  std::vector<PlaneBox> boxes;
  boxes.reserve(triangles.size());
  for (const PlaneTriangle& t : triangles) boxes.push_back(t.box());
  const BoxTree tree(boxes);
  for_blocks(static_cast<int>(triangles.size()), block_size, [&](int begin, int end, int block) {
    std::vector<int> others;
    for (int i = begin; i < end; ++i) {
      others.clear();
      tree.query(boxes[at(i)], [&](int j) {
        if (j != i && interiors_meet(triangles[at(i)], triangles[at(j)])) others.push_back(j);
      });
      if (!others.empty() || triangles[at(i)].copies.size() > 1) visit(i, others, block);
    }
  });
}

std::size_t block_count(const std::vector<PlaneTriangle>& triangles) {
  return triangles.size() / block_size + 1;
}

double total_area(const std::vector<PlaneTriangle>& triangles) {
  double twice = 0;
  for (const PlaneTriangle& t : triangles)
    twice += t.copy_count() * doubled_area(t.corner[0], t.corner[1], t.corner[2]);
  return 0.5 * twice;
}

}  // namespace

Overlap find_overlap(const Points2& uv, const Triangles& triangles) {
  const PlaneTriangles plane(uv, triangles);
  const Measure measure(plane.triangles);
  struct Found {
    Areas areas;
    std::vector<int> triangles;
  };
  std::vector<Found> found(block_count(plane.triangles));
  for_each_overlapped(plane.triangles, [&](int i, const std::vector<int>& others, int block) {
    Found& own = found[at(block)];
    const Areas areas = measure.contribution(i, others);
    own.areas.under_several += areas.under_several;
    own.areas.surplus += areas.surplus;
    const std::vector<int>& copies = plane.triangles[at(i)].copies;
    own.triangles.insert(own.triangles.end(), copies.begin(), copies.end());
  });
  Overlap overlap;
  double surplus = 0;
  for (const Found& own : found) {
    overlap.overlapped_area += own.areas.under_several;
    surplus += own.areas.surplus;
    overlap.triangles.insert(overlap.triangles.end(), own.triangles.begin(), own.triangles.end());
  }
  std::sort(overlap.triangles.begin(), overlap.triangles.end());
  const double unit_area = plane.unit * plane.unit;
  overlap.covered_area = (total_area(plane.triangles) - surplus) * unit_area;
  overlap.overlapped_area = std::max(0.0, overlap.overlapped_area) * unit_area;
  return overlap;
}

std::vector<std::array<int, 2>> overlapping_pairs(const Points2& uv, const Triangles& triangles) {
  const PlaneTriangles plane(uv, triangles);
  using Pairs = std::vector<std::array<int, 2>>;
  std::vector<Pairs> found(block_count(plane.triangles));
  for_each_overlapped(plane.triangles, [&](int i, const std::vector<int>& others, int block) {
    const std::vector<int>& copies = plane.triangles[at(i)].copies;
    const auto add = [&](int a, int b) {
      if (a < b) found[at(block)].push_back({a, b});
    };
    for (const int a : copies) {
      for (const int b : copies) add(a, b);
      for (const int other : others)
        for (const int b : plane.triangles[at(other)].copies) add(a, b);
    }
  });
  Pairs pairs;
  for (const Pairs& own : found) pairs.insert(pairs.end(), own.begin(), own.end());
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace isostretch::mesh
