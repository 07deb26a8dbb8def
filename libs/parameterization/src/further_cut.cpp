#include "further_cut.hpp"

#include <isostretch/surface/boundary.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <utility>

namespace isostretch::parameterization {
namespace {

double area_of(const Domain& domain) {
  double area = 0;
  for (const mesh::Chart& chart : domain.cut.charts) area += chart.area;
  return area;
}

double distortion_of(const std::vector<double>& stretches, std::size_t triangle) {
  const double largest = stretches[2 * triangle], smallest = stretches[2 * triangle + 1];
  return smallest > 0 ? std::max(largest, 1 / smallest) : HUGE_VAL;
}

}  // namespace

double worst_distortion(const std::vector<double>& stretches) {
  double worst = 1;
  for (std::size_t t = 0; 2 * t < stretches.size(); ++t) worst = std::max(worst, distortion_of(stretches, t));
  return worst;
}

namespace {

struct Spot {
  double score = 0;
  int vertex = -1;
};

// A spot deep inside gains more from a cut than a triangle beside the boundary, which would be cut off edge
// by edge: excess counts times distance.
std::vector<Spot> spots(const mesh::SurfaceMesh& open, const std::vector<double>& stretches, double bound,
                        const std::vector<double>& distance) {
  std::map<int, double> scores;
  for (Eigen::Index t = 0; t < open.triangles.rows(); ++t) {
    const double excess = std::log(distortion_of(stretches, static_cast<std::size_t>(t)) / bound);
    if (!(excess > 0)) continue;
    for (const int v : open.triangles.row(t)) {
      double& score = scores[v];
      score = std::max(score, excess * distance[static_cast<std::size_t>(v)]);
    }
  }
  std::vector<Spot> result;
  for (const auto& [vertex, score] : scores)
    if (score > 0) result.push_back({score, vertex});
  std::stable_sort(result.begin(), result.end(),
                   [](const Spot& a, const Spot& b) { return a.score > b.score; });
  return result;
}

}  // namespace

// One cut relieves its surroundings: what lies as near to a spot as the boundary does twice over waits.
std::vector<int> worst_vertices(const Domain& domain, const std::vector<double>& stretches, double bound) {
  const mesh::SurfaceMesh& open = domain.open();
  const std::vector<double> distance = mesh::distance_to_boundary(open);
  std::vector<int> chosen;
  for (const Spot& spot : spots(open, stretches, bound, distance)) {
    const auto place = open.vertices.row(spot.vertex);
    const bool near = std::any_of(chosen.begin(), chosen.end(), [&](int other) {
      const double reach = 2 * std::max(distance[static_cast<std::size_t>(other)],
                                        distance[static_cast<std::size_t>(spot.vertex)]);
      return (open.vertices.row(other) - place).norm() < std::max(reach, 0.12 * std::sqrt(area_of(domain)));
    });
    if (!near) chosen.push_back(spot.vertex);
  }
  return chosen;
}

namespace {

// Vertices that share a triangle with one, and how many triangles do.
struct Star {
  std::set<int> neighbours;
  std::size_t triangles = 0;
  // Inside a surface a vertex has as many neighbours as triangles.
  bool on_boundary() const { return neighbours.size() != triangles; }
};

// The triangles around every vertex, found in one pass.
class Stars {
 public:
  Stars(const mesh::Triangles& triangles, Eigen::Index vertices)
      : triangles_(triangles), begin_(static_cast<std::size_t>(vertices) + 1, 0) {
    const auto corners = static_cast<std::size_t>(triangles.size());
    for (std::size_t i = 0; i < corners; ++i) ++begin_[vertex_at(i) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    triangle_.resize(corners);
    std::vector<std::size_t> next = begin_;
    for (std::size_t i = 0; i < corners; ++i) triangle_[next[vertex_at(i)]++] = static_cast<int>(i / 3);
  }

  std::span<const int> triangles_around(int vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return std::span(triangle_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
  }

  Star of(int vertex) const {
    Star star;
    for (const int t : triangles_around(vertex)) {
      ++star.triangles;
      star.neighbours.insert(triangles_.row(t).begin(), triangles_.row(t).end());
    }
    star.neighbours.erase(vertex);
    return star;
  }

 private:
  std::size_t vertex_at(std::size_t corner) const {
    return static_cast<std::size_t>(triangles_.data()[corner]);
  }

  const mesh::Triangles& triangles_;
  std::vector<std::size_t> begin_;
  std::vector<int> triangle_;
};

// Where a cut that ends at the vertex comes from; -1: none ends there. Both sides of its last edge are at the
// vertex.
int comes_from(const Domain& domain, const Star& star) {
  std::map<int, int> copies;
  for (const int v : star.neighbours) {
    const int original = domain.cut.original_vertex[static_cast<std::size_t>(v)];
    if (star.on_boundary() && ++copies[original] == 2) return v;
  }
  return -1;
}

// Two edges on from the end of a cut, as straight as edges allow; -1: nothing lies ahead.
int straight_on(const Domain& domain, const Stars& stars, int end, int from, const Star& around_end) {
  const mesh::SurfaceMesh& open = domain.open();
  const Eigen::RowVector3d ahead = (open.vertices.row(end) - open.vertices.row(from)).normalized();
  double straightest = 0.7;
  int best = -1;
  for (const int near : around_end.neighbours) {
    const Star star = stars.of(near);
    if (star.on_boundary()) continue;
    for (const int v : star.neighbours) {
      if (v == end || around_end.neighbours.count(v) > 0 || stars.of(v).on_boundary()) continue;
      const double cosine = (open.vertices.row(v) - open.vertices.row(end)).normalized().dot(ahead);
      if (cosine > straightest) straightest = cosine, best = v;
    }
  }
  return best;
}

// A triangle beside the end of a cut is distorted because the cut ends too early: it goes straight on.
int place_to_reach(const Domain& domain, const Stars& stars, int vertex, const Star& star) {
  for (const int end : star.neighbours) {
    const Star around = stars.of(end);
    const int from = comes_from(domain, around);
    const int ahead = from < 0 ? -1 : straight_on(domain, stars, end, from, around);
    if (ahead >= 0) return ahead;
  }
  return vertex;
}

}  // namespace

int cut_at(Domain& domain, int vertex, OnFromEnd on, mesh::Points2& uv) {
  const Stars stars(domain.open().triangles, domain.open().vertices.rows());
  const Star star = stars.of(vertex);
  if (star.on_boundary()) return -1;
  if (on == OnFromEnd::straight) vertex = place_to_reach(domain, stars, vertex, star);
  const int chart = domain.cut.chart[static_cast<std::size_t>(stars.triangles_around(vertex).front())];
  uv = rows_of(uv, mesh::extend_cut(domain.cut, vertex));
  return chart;
}

namespace {

// Triangles above the bound that hang together with those around the vertex, and these.
std::vector<int> distorted_around(const Domain& domain, const Stars& stars,
                                  const std::vector<double>& stretches, double bound, int vertex) {
  const std::span<const int> around = stars.triangles_around(vertex);
  std::vector<int> place(around.begin(), around.end());
  std::set<int> seen(place.begin(), place.end());
  for (std::size_t i = 0; i < place.size(); ++i)
    for (const int v : domain.open().triangles.row(place[i]))
      for (const int t : stars.triangles_around(v))
        if (distortion_of(stretches, static_cast<std::size_t>(t)) > bound && seen.insert(t).second)
          place.push_back(t);
  return place;
}

}  // namespace

std::vector<int> part_to_cut_off(const Domain& domain, const std::vector<double>& stretches, double bound) {
  constexpr double scrap = 0.01;  // of the whole area
  const std::vector<int> vertices = worst_vertices(domain, stretches, bound);
  if (vertices.empty()) return {};
  const Stars stars(domain.open().triangles, domain.open().vertices.rows());
  const std::vector<double> way = mesh::distance_to_boundary(domain.open());
  const mesh::Encloser encloser(domain.cut);
  // A loop around the worst of the place is shorter than one around all of it.
  const double worse = std::sqrt(bound * std::min(worst_distortion(stretches), bound * bound * bound));
  for (const int vertex : vertices)
    for (const double above : {worse, bound}) {
      const std::vector<int> place = distorted_around(domain, stars, stretches, above, vertex);
      mesh::Enclosure part = encloser.enclose(place, way[static_cast<std::size_t>(vertex)]);
      if (!part.triangles.empty() && part.area >= scrap * area_of(domain)) return std::move(part.triangles);
    }
  return {};
}

std::vector<int> make_apart(Domain& domain, const std::vector<int>& triangles, mesh::Points2& uv) {
  std::vector<int> part = domain.cut.chart;
  for (const int t : triangles)
    part[static_cast<std::size_t>(t)] = static_cast<int>(domain.cut.charts.size());
  std::map<int, int> number;  // by first triangles
  for (int& own : part) own = number.emplace(own, static_cast<int>(number.size())).first->second;
  const mesh::Division division = mesh::divide_charts(domain.cut, part);
  uv = rows_of(uv, division.previous_vertex);
  return division.previous_chart;
}

int worst_triangle(const Domain& domain, const std::vector<double>& stretches, double bound) {
  const mesh::Triangles& triangles = domain.open().triangles;
  std::vector<int> size(domain.cut.charts.size(), 0);
  for (const int chart : domain.cut.chart) ++size[static_cast<std::size_t>(chart)];
  double highest = bound;
  int worst = -1;
  for (int t = 0; t < triangles.rows(); ++t) {
    const double own = distortion_of(stretches, static_cast<std::size_t>(t));
    const int chart = domain.cut.chart[static_cast<std::size_t>(t)];
    if (own > highest && size[static_cast<std::size_t>(chart)] > 1) highest = own, worst = t;
  }
  return worst;
}

namespace {

// The longest edge of the triangle that another triangle shares in the opened mesh, in the input's numbering.
mesh::Edge longest_inner_edge(const Domain& domain, int triangle) {
  const mesh::SurfaceMesh& open = domain.open();
  std::set<std::pair<int, int>> reversed;  // edges of all triangles, as the neighbour runs through them
  for (Eigen::Index t = 0; t < open.triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c) reversed.emplace(open.triangles(t, (c + 1) % 3), open.triangles(t, c));
  mesh::Edge longest{-1, -1};
  double length = -1;
  for (int c = 0; c < 3; ++c) {
    const int a = open.triangles(triangle, c), b = open.triangles(triangle, (c + 1) % 3);
    const double own = (open.vertices.row(a) - open.vertices.row(b)).norm();
    if (reversed.count({a, b}) == 0 || own <= length) continue;
    length = own;
    const int i = domain.cut.original_vertex[static_cast<std::size_t>(a)],
              j = domain.cut.original_vertex[static_cast<std::size_t>(b)];
    longest = {std::min(i, j), std::max(i, j)};
  }
  return longest;
}

// The domain cut along these seams and no others. uv follows; where several vertices become one it is their
// middle, by corners. Returns the chart before of every chart.
std::vector<int> recut(Domain& domain, std::vector<mesh::Edge> seams, mesh::Points2& uv) {
  mesh::CutOptions cut;
  cut.holes = mesh::Holes::keep_all;  // what had to be cut is among the seams
  cut.seams = std::move(seams);
  const mesh::Cut before = std::exchange(domain.cut, mesh::cut_to_disks(domain.input, cut));
  const mesh::Triangles& triangles = domain.open().triangles;
  mesh::Points2 carried = mesh::Points2::Zero(domain.open().vertices.rows(), 2);
  std::vector<double> corners(static_cast<std::size_t>(carried.rows()), 0.0);
  std::vector<int> part_of(domain.cut.charts.size(), -1);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const int v = triangles(t, c);
      // The mean of equal rows is that row, to the bit.
      carried.row(v) +=
          (uv.row(before.mesh.triangles(t, c)) - carried.row(v)) / ++corners[static_cast<std::size_t>(v)];
    }
    part_of[static_cast<std::size_t>(domain.cut.chart[static_cast<std::size_t>(t)])] =
        before.chart[static_cast<std::size_t>(t)];
  }
  uv = carried;
  return part_of;
}

}  // namespace

std::vector<int> cut_off(Domain& domain, int triangle, mesh::Points2& uv) {
  std::vector<mesh::Edge> seams = domain.cut.seams;
  seams.push_back(longest_inner_edge(domain, triangle));
  return recut(domain, std::move(seams), uv);
}

int sew(Domain& domain, const std::vector<int>& path, mesh::Points2& uv) {
  std::vector<mesh::Edge> seams = domain.cut.seams;
  for (std::size_t i = 1; i < path.size(); ++i)
    std::erase(seams, mesh::Edge{std::min(path[i - 1], path[i]), std::max(path[i - 1], path[i])});
  recut(domain, std::move(seams), uv);
  const mesh::Triangles& triangles = domain.open().triangles;
  for (Eigen::Index i = 0; i < triangles.size(); ++i)
    if (domain.cut.original_vertex[static_cast<std::size_t>(triangles.data()[i])] == path.front())
      return domain.cut.chart[static_cast<std::size_t>(i / 3)];
  return -1;
}

}  // namespace isostretch::parameterization
