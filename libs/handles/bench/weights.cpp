// Bounded biharmonic weights of handles scattered over a mesh: prints one line of CSV, and what was done for
// every handle.
//
//   isostretch_weights grid|bar|shaken|quadruped n [handles=10] [tolerance=1e-9]
//
// shaken: the bar with vertices moved at random, so that it has no right angles.
#include "../tests/body.hpp"

#include <isostretch/core/timer.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/handles/bounded_weights.hpp>
#include <isostretch/mesh/generators.hpp>

#include <cstdio>
#include <exception>
#include <random>
#include <stdexcept>
#include <string>

namespace {

using namespace isostretch;

using tests::Body;
using tests::body;

void shake(mesh::Points3& vertices, double length) {
  std::mt19937 random(1);
  for (auto& coordinate : vertices.reshaped())
    coordinate += length * (static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 0.5);
}

Body body_of(const std::string& kind, int n) {
  if (kind == "grid") {
    const auto sheet = mesh::grid(n, n);
    const mesh::Points2 flat = sheet.vertices.leftCols<2>();
    return body(mesh::elements(flat, sheet.triangles), flat);
  }
  if (kind != "bar" && kind != "shaken" && kind != "quadruped")
    throw std::invalid_argument("unknown mesh '" + kind + "'; there are grid, bar, shaken, quadruped");
  auto tets = kind == "quadruped" ? mesh::quadruped(n) : mesh::tet_bar(n, 3 * n / 8, 3 * n / 8, 8, 3, 3);
  if (kind == "shaken") shake(tets.vertices, 0.2 * 8 / n);
  return body(mesh::elements(tets), tets.vertices);
}

int run(int argc, char** argv) {
  if (argc < 3)
    throw std::invalid_argument(
        "arguments: grid, bar, shaken or quadruped, cells along it, handles, tolerance");
  const Body b = body_of(argv[1], std::stoi(argv[2]));
  const auto chosen = tests::scattered(b.nodes, argc > 3 ? std::stoi(argv[3]) : 10);
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
