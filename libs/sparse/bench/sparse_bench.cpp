// Factorization and solution of block Laplacians: back ends and orderings.
#include "../tests/matrices.hpp"

#include <isostretch/sparse/solver.hpp>

#include <benchmark/benchmark.h>

#include <string>

using namespace isostretch::sparse;

namespace {

void report(benchmark::State& state, const Solver& solver) {
  const Statistics& s = solver.statistics();
  state.counters["analyze_ms"] = 1e3 * s.analyze_seconds / s.analyze_calls;
  state.counters["ordering_ms"] = 1e3 * s.ordering_seconds / s.analyze_calls;
  state.counters["factorize_ms"] = 1e3 * s.factorize_seconds / s.factorize_calls;
  state.counters["solve_ms"] = 1e3 * s.solve_seconds / s.solve_calls;
  state.counters["nnz_L"] = s.factor_nonzeros;
  state.counters["Gflop"] = 1e-9 * s.factor_flops;
  state.SetLabel(std::string(backend_name(s.backend)) + " " + std::string(ordering_name(s.ordering)));
}

void factor_and_solve(benchmark::State& state, const SymmetricMatrix& A, const Options& options) {
  const auto solver = make_solver(options);
  solver->analyze(A);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(A.size);
  Eigen::VectorXd x;
  for (auto _ : state) {
    solver->factorize(A);
    solver->solve(b, x);
    benchmark::DoNotOptimize(x.data());
  }
  report(state, *solver);
}

void register_all(const std::string& name, const SymmetricMatrix& A) {
  for (const Backend backend : available_backends())
    for (const Ordering ordering : available_orderings()) {
      if (ordering == Ordering::natural) continue;
      if (backend == Backend::pcg && ordering != Ordering::amd) continue;
      Options options;
      options.backend = backend;
      options.ordering = ordering;
      const std::string label =
          name + "/" + std::string(backend_name(backend)) + "/" + std::string(ordering_name(ordering));
      benchmark::RegisterBenchmark(
          label.c_str(), [&A, options](benchmark::State& state) { factor_and_solve(state, A, options); })
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
    }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const SymmetricMatrix small = test::grid_2d(40), medium = test::grid_2d(80), large = test::grid_2d(161),
                        tets_small = test::grid_3d(9), tets = test::grid_3d(17);
  register_all("grid_2d/1600_nodes", small);
  register_all("grid_2d/6400_nodes", medium);
  register_all("grid_2d/25921_nodes", large);
  register_all("grid_3d/729_nodes", tets_small);
  register_all("grid_3d/4913_nodes", tets);
  benchmark::RunSpecifiedBenchmarks();
}
