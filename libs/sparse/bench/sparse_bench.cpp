// Factorization and solution: block Laplacians by back ends and orderings, elasticity by preconditioners too.
#include "../tests/elasticity.hpp"
#include "../tests/matrices.hpp"

#include <isostretch/sparse/solver.hpp>

#include <benchmark/benchmark.h>

#include <fstream>
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

// A pattern that gains and loses a few far couplings, as contact makes them: pattern/<name>/<new ordering or
// kept>.
SymmetricMatrix with_couplings(const SymmetricMatrix& A, int dim, int count, int first) {
  test::Triplets triplets;
  for (int j = 0; j < A.size; ++j)
    for (int k = A.column_start[j]; k < A.column_start[j + 1]; ++k) {
      triplets.emplace_back(A.row[k], j, A.value[k]);
      if (A.row[k] != j) triplets.emplace_back(j, A.row[k], A.value[k]);
    }
  const int nodes = A.size / dim, half = nodes / 2;
  for (int i = 0; i < count; ++i)
    test::add_edge(triplets, (first + 7 * i) % half, half + (3 * first + 7 * i) % half, dim, 1.0);
  return test::finish(nodes, dim, 0, triplets);
}

void change_pattern(benchmark::State& state, const SymmetricMatrix& A, int dim, int count, bool keep) {
  Options options;
  options.backend = available_backends().front();
  const auto solver = make_solver(options);
  solver->analyze(A);
  const SymmetricMatrix patterns[] = {with_couplings(A, dim, count, 1), with_couplings(A, dim, count, 100)};
  int round = 0;
  for (auto _ : state) {
    const SymmetricMatrix& next = patterns[round++ % 2];
    keep ? solver->update_pattern(next) : solver->analyze(next);
  }
  solver->factorize(patterns[(round + 1) % 2]);
  report(state, *solver);
  state.counters["orderings"] = solver->statistics().orderings;
}

void register_changes(const std::string& name, const SymmetricMatrix& A, int dim) {
  for (const int count : {1, 30, 300})
    for (const bool keep : {false, true}) {
      const std::string label = "pattern/" + name + "/" + std::to_string(count) + "_couplings/" +
                                (keep ? "ordering_kept" : "ordering_anew");
      benchmark::RegisterBenchmark(label.c_str(), [=, &A](benchmark::State& state) {
        change_pattern(state, A, dim, count, keep);
      })->Unit(benchmark::kMillisecond);
    }
}

// Largest memory of the process so far, in MB: run one case a process for a figure of its own.
double peak_memory() {
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0;
  while (status >> word)
    if (word == "VmHWM:") status >> kilobytes;
  return kilobytes / 1024;
}

// One matrix from nothing: analysis, factorization and one solution.
void solve_elasticity(benchmark::State& state, const test::ElasticBox& box, const Options& options) {
  const test::ElasticSystem system = test::elastic_box(box);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(system.A.size), x;
  for (int i = 2; i < system.A.size; i += 3) b[i] = 1;  // a load sideways
  for (auto _ : state) {
    const auto solver = make_solver(options);
    solver->set_coordinates(system.coords.data(), 3, system.nodes);
    solver->analyze(system.A);
    solver->factorize(system.A);
    const SolveResult result = solver->solve(b, x);
    report(state, *solver);
    state.counters["multiplications"] = result.iterations;
    if (!result) state.SkipWithError(result.message.c_str());
  }
  state.counters["unknowns"] = system.A.size;
  state.counters["residual"] = test::relative_residual(system.A, x, b);
  state.counters["peak_MB"] = peak_memory();
}

void register_case(const std::string& name, const test::ElasticBox& box, const Options& options) {
  benchmark::RegisterBenchmark(
      name.c_str(), [box, options](benchmark::State& state) { solve_elasticity(state, box, options); })
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1)
      ->UseRealTime();
}

// elasticity/<cells along an edge>/<material>/<solver>/<tolerance>
void register_elasticity(int cells, const std::string& material, double poisson, double height) {
  test::ElasticBox box;
  for (int& n : box.cells) n = cells;
  box.poisson = poisson;
  box.size[2] = height;
  const std::string name = "elasticity/" + std::to_string(cells) + "/" + material + "/";
  for (const Backend backend :
       {Backend::automatic, Backend::cholmod_supernodal, Backend::multifrontal, Backend::eigen_ldlt}) {
    if (!is_available(backend)) continue;
    Options options;
    options.backend = backend;
    register_case(name + std::string(backend_name(backend)), box, options);
  }
  for (const Preconditioner preconditioner :
       {Preconditioner::jacobi, Preconditioner::block_jacobi, Preconditioner::incomplete_cholesky,
        Preconditioner::stale_cholesky, Preconditioner::amg})
    for (const char* tolerance : {"1e-4", "1e-8"}) {
      Options options;
      options.backend = Backend::pcg;
      options.pcg_preconditioner = preconditioner;
      options.pcg_tolerance = std::stod(tolerance);
      register_case(name + std::string(preconditioner_name(preconditioner)) + "/" + tolerance, box, options);
    }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const SymmetricMatrix small = test::grid_2d(40), medium = test::grid_2d(80), large = test::grid_2d(161),
                        huge = test::grid_2d(425), tets_small = test::grid_3d(9), tets = test::grid_3d(17);
  register_all("grid_2d/1600_nodes", small);
  register_all("grid_2d/6400_nodes", medium);
  register_all("grid_2d/25921_nodes", large);
  register_all("grid_2d/180625_nodes", huge);
  register_all("grid_3d/729_nodes", tets_small);
  register_all("grid_3d/4913_nodes", tets);
  register_changes("grid_2d/25921_nodes", large, 2);
  register_changes("grid_3d/4913_nodes", tets, 3);
  for (const int cells : {12, 16, 24, 32, 40, 56}) {
    register_elasticity(cells, "plain", 0.3, 1);
    register_elasticity(cells, "incompressible", 0.495, 1);
    register_elasticity(cells, "flat", 0.3, 0.1);
  }
  benchmark::RunSpecifiedBenchmarks();
}
