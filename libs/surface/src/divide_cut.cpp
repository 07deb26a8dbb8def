#include "overlap_parts.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/index.hpp>
#include <isostretch/mesh/gather.hpp>
#include <isostretch/mesh/measure.hpp>
#include <isostretch/surface/cut.hpp>
#include <isostretch/surface/topology.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace isostretch::mesh {
namespace {

void require_parts(const Cut& cut, const std::vector<int>& part) {
  if (part.size() != cut.chart.size())
    throw Error("divide_charts: " + std::to_string(part.size()) + " part numbers for " +
                std::to_string(cut.chart.size()) + " triangles");
  int next = 0;
  for (std::size_t t = 0; t < part.size(); ++t) {
    if (part[t] < 0 || part[t] > next)
      throw Error("divide_charts: triangle " + std::to_string(t) + " is in part " + std::to_string(part[t]) +
                  ", where " + std::to_string(next) + " or less comes next");
    next = std::max(next, part[t] + 1);
  }
}

// A copy of a vertex for every fan of triangles of one part, of which that of the smallest corner keeps the
// number.
std::vector<int> open_between(Cut& cut, const std::vector<int>& part) {
  Triangles& triangles = cut.mesh.triangles;
  UnionFind fans(static_cast<int>(triangles.size()));
  for_each_edge(sorted_sides(triangles), [&](const Side* begin, const Side* end) {
    std::map<int, const Side*> first;  // of every part
    for (const Side* side = begin; side < end; ++side)
      join_corners(fans, *first.emplace(part[at(side->triangle)], side).first->second, *side);
  });
  std::vector<int> previous(static_cast<std::size_t>(cut.mesh.vertices.rows()));
  for (std::size_t v = 0; v < previous.size(); ++v) previous[v] = static_cast<int>(v);
  std::vector<char> kept(previous.size(), 0);
  std::map<int, int> number;  // of the fan that a corner stands for
  for (int i = 0; i < triangles.size(); ++i) {
    int& vertex = triangles.data()[i];
    const auto [known, is_new] = number.emplace(fans.find(i), vertex);
    if (is_new && kept[at(vertex)]) {
      known->second = static_cast<int>(previous.size());
      previous.push_back(vertex);
    } else if (is_new) {
      kept[at(vertex)] = 1;
    }
    vertex = known->second;
  }
  return previous;
}

Edge original_edge(const Cut& cut, int a, int b) {
  const auto [low, high] = std::minmax({cut.original_vertex[at(a)], cut.original_vertex[at(b)]});
  return {low, high};
}

void note_seams(Cut& cut, const std::vector<int>& part) {
  for_each_edge(sorted_sides(cut.mesh.triangles), [&](const Side* begin, const Side* end) {
    for (const Side* side = begin + 1; side < end; ++side)
      if (part[at(side->triangle)] != part[at(begin->triangle)]) {
        cut.seams.push_back(original_edge(cut, begin->low, begin->high));
        return;
      }
  });
  std::sort(cut.seams.begin(), cut.seams.end());
  cut.seams.erase(std::unique(cut.seams.begin(), cut.seams.end()), cut.seams.end());
}

int count_loops(const std::vector<std::pair<int, int>>& boundary) {
  std::map<int, int> number;
  for (const auto& [a, b] : boundary)
    for (const int v : {a, b}) number.emplace(v, static_cast<int>(number.size()));
  UnionFind loops(static_cast<int>(number.size()));
  for (const auto& [a, b] : boundary) loops.unite(number[a], number[b]);
  int count = 0;
  for (int v = 0; v < static_cast<int>(number.size()); ++v) count += loops.find(v) == v;
  return count;
}

// Sizes, loops and seams of the charts as they are now.
void measure_charts(Cut& cut) {
  for (Chart& chart : cut.charts) chart.triangles = chart.loops = 0, chart.area = chart.seam_length = 0;
  for (Eigen::Index t = 0; t < cut.mesh.triangles.rows(); ++t) {
    Chart& chart = cut.charts[at(cut.chart[static_cast<std::size_t>(t)])];
    ++chart.triangles;
    chart.area += triangle_shape(cut.mesh.vertices, cut.mesh.triangles.row(t)).area();
  }
  std::vector<std::vector<std::pair<int, int>>> boundary(cut.charts.size());
  std::map<std::pair<int, int>, double> seam;  // of a chart
  for_each_edge(sorted_sides(cut.mesh.triangles), [&](const Side* begin, const Side* end) {
    if (end - begin != 1) return;
    const int chart = cut.chart[at(begin->triangle)];
    boundary[at(chart)].emplace_back(begin->low, begin->high);
    const Edge edge = original_edge(cut, begin->low, begin->high);
    const auto found = std::lower_bound(cut.seams.begin(), cut.seams.end(), edge);
    if (found != cut.seams.end() && *found == edge)
      seam[{chart, static_cast<int>(found - cut.seams.begin())}] =
          length(edge_vector(cut.mesh.vertices, begin->low, begin->high));
  });
  for (std::size_t c = 0; c < boundary.size(); ++c) cut.charts[c].loops = count_loops(boundary[c]);
  for (const auto& [where, size] : seam) cut.charts[at(where.first)].seam_length += size;
}

// One way to take charts apart, and what it leaves.
struct Divided {
  Cut cut;
  Division division;
  std::size_t spurs = 0;
};

}  // namespace

Division divide_charts(Cut& cut, const std::vector<int>& part) {
  require_parts(cut, part);
  note_seams(cut, part);
  Division division;
  division.previous_vertex = open_between(cut, part);
  const std::vector<int> known = cut.original_vertex;
  cut.original_vertex.clear();
  for (const int v : division.previous_vertex) cut.original_vertex.push_back(known[at(v)]);
  cut.mesh.vertices = gather(cut.mesh.vertices, division.previous_vertex);
  std::vector<Chart> charts;
  for (std::size_t t = 0; t < part.size(); ++t)
    if (part[t] == static_cast<int>(charts.size())) {
      charts.push_back(cut.charts[at(cut.chart[t])]);
      division.previous_chart.push_back(cut.chart[t]);
    }
  cut.charts = std::move(charts);
  cut.chart = part;
  measure_charts(cut);
  return division;
}

Division split_overlap(Cut& cut, const Points2& uv) {
  if (uv.rows() != cut.mesh.vertices.rows())
    throw Error("split_overlap: " + std::to_string(uv.rows()) + " points for " +
                std::to_string(cut.mesh.vertices.rows()) + " vertices");
  const Partners partners = overlap_partners(cut, uv);
  const std::size_t before = spurs(cut).size();
  std::optional<Divided> best;
  for (const int spur_detour : {1, 2, 4, 8}) {
    Divided now{cut, {}, 0};
    now.division = divide_charts(now.cut, parts_without_overlap(cut, uv, partners, spur_detour));
    now.spurs = spurs(now.cut).size();
    if (!best || now.spurs < best->spurs) best = std::move(now);
    if (best->spurs <= before) break;
  }
  cut = std::move(best->cut);
  return std::move(best->division);
}

}  // namespace isostretch::mesh
