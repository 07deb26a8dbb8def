// Bounded biharmonic weights of handles scattered over a mesh: prints one line of CSV, and what was done for
// every handle.
//
//   isostretch_weights grid|bar|quadruped n [handles=10] [tolerance=1e-9]
#include "../tests/body.hpp"

#include <isostretch/core/timer.hpp>
#include <isostretch/handles/bounded_weights.hpp>
#include <isostretch/handles/selection.hpp>
#include <isostretch/mesh/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>

namespace {

using namespace isostretch;

using tests::Body;
using tests::body;

Body body_of(const std::string& kind, int n) {
  if (kind == "grid") {
    const auto sheet = mesh::grid(n, n);
    const mesh::Points2 flat = sheet.vertices.leftCols<2>();
    return body(mesh::elements(flat, sheet.triangles), flat);
  }
  if (kind != "bar" && kind != "quadruped")
    throw std::invalid_argument("unknown mesh '" + kind + "'; there are grid, bar, quadruped");
  const auto tets = kind == "bar" ? mesh::tet_bar(n, 3 * n / 8, 3 * n / 8, 8, 3, 3) : mesh::quadruped(n);
  return body(mesh::elements(tets), tets.vertices);
}

// Each around the node farthest from the others.
std::vector<std::vector<int>> scattered(const handles::Nodes& nodes, int count) {
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

int run(int argc, char** argv) {
  if (argc < 3)
    throw std::invalid_argument("arguments: grid, bar or quadruped, cells along it, handles, tolerance");
  const Body b = body_of(argv[1], std::stoi(argv[2]));
  const auto chosen = scattered(b.nodes, argc > 3 ? std::stoi(argv[3]) : 10);
  handles::WeightOptions options;
  if (argc > 4) options.tolerance = std::stod(argv[4]);
  const Timer timer;
  const handles::HandleWeights weights = handles::bounded_biharmonic_weights(b.elements, chosen, options);
  const double seconds = timer.seconds();
  int iterations = 0, factorizations = 1;
  for (const handles::WeightReport& r : weights.reports) {
    iterations += r.iterations;
    factorizations += r.factorizations;
  }
  std::printf("mesh,nodes,handles,seconds,factorizations,iterations\n%s %s,%d,%d,%.2f,%d,%d\n", argv[1],
              argv[2], b.nodes.count(), weights.handles, seconds, factorizations, iterations);
  for (const handles::WeightReport& r : weights.reports)
    std::printf("  %d iterations%s, %d nodes at 0, %d at 1, KKT residual %.1e\n", r.iterations,
                r.descended ? " with descent" : "", r.at_zero, r.at_one, r.kkt_residual);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
