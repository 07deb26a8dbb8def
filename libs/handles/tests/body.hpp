#pragma once

// Meshes as the library takes them and handles on them, for tests and benchmarks.
#include <isostretch/assembly/elements.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/handles/selection.hpp>

#include <algorithm>
#include <limits>
#include <vector>

namespace isostretch::tests {

struct Body {
  assembly::Elements elements;
  handles::Nodes nodes;
};

template <class Points>
Body body(const mesh::ElementArrays& arrays, const Points& points) {
  Body b{assembly::elements_from(arrays), {}};
  b.nodes.dim = arrays.dim;
  b.nodes.positions = Vector::Map(points.data(), points.size());
  return b;
}

// Handles, each around the node farthest from the others.
inline std::vector<std::vector<int>> scattered(const handles::Nodes& nodes, int count) {
  std::vector<double> distance(static_cast<std::size_t>(nodes.count()),
                               std::numeric_limits<double>::infinity());
  std::vector<handles::Point> centers;
  for (int h = 0; h < count; ++h) {
    const auto far = std::max_element(distance.begin(), distance.end()) - distance.begin();
    centers.push_back(nodes.at(static_cast<int>(far)));
    for (int n = 0; n < nodes.count(); ++n) {
      double& d = distance[static_cast<std::size_t>(n)];
      d = std::min(d, (nodes.at(n) - centers.back()).norm());
    }
  }
  const double radius = 0.25 * *std::max_element(distance.begin(), distance.end());
  std::vector<std::vector<int>> chosen;
  for (const handles::Point& center : centers)
    chosen.push_back(handles::select(handles::Sphere{center, radius}, nodes, "handle"));
  return chosen;
}

}  // namespace isostretch::tests
