#include "minimum_cut.hpp"
#include "triangle_graph.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/index.hpp>
#include <isostretch/mesh/measure.hpp>
#include <isostretch/surface/cut.hpp>

#include <algorithm>
#include <limits>
#include <string>

namespace isostretch::mesh {
namespace {

// Triangles of the chart, those with a side on its boundary, and the ones to enclose, which count most.
std::vector<signed char> marked(const Cut& cut, const TriangleGraph& graph,
                                const std::vector<int>& triangles) {
  const int chart = cut.chart[at(triangles.front())];
  std::vector<signed char> mark(cut.chart.size(), -1);
  for (std::size_t t = 0; t < mark.size(); ++t)
    if (cut.chart[t] == chart) {
      const int* opposite = graph.opposite.data() + 3 * t;
      mark[t] = std::any_of(opposite, opposite + 3, [](int h) { return h < 0; }) ? 2 : 0;
    }
  for (const int t : triangles) {
    if (cut.chart[at(t)] != chart)
      throw Error("enclose: triangles " + std::to_string(triangles.front()) + " and " + std::to_string(t) +
                  " are of different charts");
    if (mark[at(t)] == 2) return {};
    mark[at(t)] = 1;
  }
  return mark;
}

}  // namespace

Encloser::Encloser(const Cut& cut)
    : cut_(cut), graph_(std::make_unique<const TriangleGraph>(triangle_graph(cut, 1))) {}

Encloser::~Encloser() = default;

Enclosure Encloser::enclose(const std::vector<int>& triangles, double limit) const {
  for (const int t : triangles)
    if (t < 0 || at(t) >= cut_.chart.size())
      throw Error("enclose: there is no triangle " + std::to_string(t));
  if (triangles.empty()) return {};
  const TriangleGraph& graph = *graph_;
  const std::vector<signed char> mark = marked(cut_, graph, triangles);
  if (mark.empty()) return {};
  const double most = limit / graph.unit;
  const std::vector<char> inside = minimum_cut(
      graph, mark, most < 9e18 ? static_cast<long long>(most) : std::numeric_limits<long long>::max());
  if (std::find(mark.begin(), mark.end(), 2) == mark.end()) return {};  // a chart without a boundary
  Enclosure found;
  for (std::size_t h = 0; h < 3 * inside.size(); ++h) {
    if (h % 3 == 0 && inside[h / 3]) {
      found.triangles.push_back(static_cast<int>(h / 3));
      found.area +=
          triangle_shape(cut_.mesh.vertices, cut_.mesh.triangles.row(found.triangles.back())).area();
    }
    const int opposite = graph.opposite[h];
    if (inside[h / 3] && opposite >= 0 && !inside[at(opposite) / 3])
      found.length += static_cast<double>(graph.capacity[h]) * graph.unit;
  }
  return found;
}

}  // namespace isostretch::mesh
