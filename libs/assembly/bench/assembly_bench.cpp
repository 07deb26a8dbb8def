// Value, gradient, clamped Hessian and filled matrix of a planar grid and a tetrahedral bar, per thread
// count.
#include <isostretch/assembly/energy_assembler.hpp>
#include <isostretch/energies/registry.hpp>

#include <benchmark/benchmark.h>
#include <omp.h>

#include <Eigen/Core>

#include <random>
#include <vector>

namespace {

using namespace isostretch;

// n x n squares of two triangles, or n x n x n cubes of six tetrahedra, of edge 1.
assembly::Elements lattice(int dim, int n) {
  assembly::Elements e;
  e.dim = dim;
  e.nodes_per_element = dim + 1;
  e.points_per_element = 1;
  const int side = n + 1;
  e.node_count = dim == 2 ? side * side : side * side * side;
  const int step[3] = {1, side, side * side};
  const int orders[6][3] = {{0, 1, 2}, {1, 0, 2}, {0, 2, 1}, {2, 0, 1}, {1, 2, 0}, {2, 1, 0}};
  const int cells = dim == 2 ? n * n : n * n * n;
  for (int cell = 0; cell < cells; ++cell) {
    const int corner =
        cell % n * step[0] + cell / n % n * step[1] + (dim == 3 ? cell / (n * n) * step[2] : 0);
    // Kuhn's subdivision: one simplex per order of the axes, walking from corner to corner.
    for (const auto& order : orders) {
      if (dim == 2 && order[2] != 2) continue;
      int node = corner;
      e.nodes.push_back(node);
      for (int k = 0; k < dim; ++k) e.nodes.push_back(node += step[order[k]]);
      for (int a = 0; a <= dim; ++a)
        for (int d = 0; d < dim; ++d)
          e.gradients.push_back((a > 0 && order[a - 1] == d ? 1.0 : 0.0) -
                                (a < dim && order[a] == d ? 1.0 : 0.0));
      e.weights.push_back(dim == 2 ? 0.5 : 1.0 / 6);
    }
  }
  return e;
}

Eigen::VectorXd perturbed(int dim, int n) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  const int side = n + 1;
  const int nodes = dim == 2 ? side * side : side * side * side;
  Eigen::VectorXd x(dim * nodes);
  for (int i = 0; i < nodes; ++i) {
    const int index[3] = {i % side, i / side % side, i / (side * side)};
    for (int d = 0; d < dim; ++d) x[dim * i + d] = index[d] + uniform(generator);
  }
  return x;
}

void assemble(benchmark::State& state, int dim, int n, const char* name) {
  omp_set_num_threads(static_cast<int>(state.range(0)));
  const assembly::Elements elements = lattice(dim, n);
  assembly::EnergyAssembler assembler(elements, energies::make_energy(name));
  assembly::PatternBuilder builder(elements.node_count);
  assembler.add_stencil(builder);
  const assembly::HessianPattern pattern(assembly::FreeUnknowns(dim, elements.node_count),
                                         std::move(builder));
  assembler.set_pattern(pattern);
  sparse::SymmetricMatrix matrix = pattern.zero_matrix();
  const Eigen::VectorXd x = perturbed(dim, n);
  Eigen::VectorXd gradient(x.size());
  for (auto _ : state) {
    gradient.setZero();
    std::fill(matrix.value.begin(), matrix.value.end(), 0.0);
    const auto at = assembler.differentiate(x.data(), {}, gradient.data(), true);
    if (!(at.value < 1e300)) state.SkipWithError("energy is not finite");
    assembler.add_hessian(matrix.value.data());
  }
  state.counters["ns_per_element"] =
      benchmark::Counter(elements.element_count() * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace

BENCHMARK_CAPTURE(assemble, triangles_131k_symmetric_dirichlet, 2, 256, "symmetric_dirichlet")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(assemble, triangles_131k_arap, 2, 256, "arap")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(assemble, tets_94k_symmetric_dirichlet, 3, 25, "symmetric_dirichlet")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(assemble, tets_94k_stable_neo_hookean, 3, 25, "stable_neo_hookean")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
