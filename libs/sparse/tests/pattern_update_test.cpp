// Patterns that change a little, and solvers registered from outside.
#include "matrices.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/sparse/solver.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>

using namespace isostretch;
using namespace isostretch::sparse;
using namespace isostretch::sparse::test;

namespace {

// The grid with springs between nodes that are far from each other.
SymmetricMatrix coupled_grid(int n, const std::vector<std::pair<int, int>>& springs) {
  Triplets triplets;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (i + 1 < n) add_edge(triplets, i * n + j, (i + 1) * n + j, 2, 1.0);
      if (j + 1 < n) add_edge(triplets, i * n + j, i * n + j + 1, 2, 1.2);
    }
  for (const auto& [a, b] : springs) add_edge(triplets, a, b, 2, 10.0);
  return finish(n * n, 2, 1e-2, triplets);
}

void check_solution(Solver& solver, const SymmetricMatrix& A) {
  const FactorResult factored = solver.factorize(A);
  REQUIRE_MESSAGE(factored, factored.message);
  const Eigen::VectorXd b = random_vector(A.size, 5);
  Eigen::VectorXd x;
  const SolveResult solved = solver.solve(b, x);
  CHECK_MESSAGE(solved, solved.message);
  CHECK(relative_residual(A, x, b) < 1e-9);
}

}  // namespace

TEST_CASE("sparse solver: a pattern that changes a little is solved with the ordering there is") {
  const int n = 30;
  const SymmetricMatrix first = coupled_grid(n, {}), second = coupled_grid(n, {{0, 899}, {29, 400}}),
                        third = coupled_grid(n, {{870, 450}});
  int direct = 0;
  for (const Backend backend : available_backends())
    for (const Preconditioner preconditioner : all_preconditioners()) {
      if (backend != Backend::pcg && preconditioner != Preconditioner::jacobi) continue;
      CAPTURE(backend_name(backend));
      CAPTURE(preconditioner_name(preconditioner));
      Options options;
      options.backend = backend;
      options.pcg_preconditioner = preconditioner;
      options.pcg_tolerance = 1e-10;
      const auto solver = make_solver(options);
      REQUIRE(solver->analyze(first));
      check_solution(*solver, first);
      for (const SymmetricMatrix* next : {&second, &third, &first}) {
        CHECK_THROWS_WITH_AS(solver->factorize(*next), doctest::Contains("not the one given to analyze()"),
                             Error);
        REQUIRE(solver->update_pattern(*next));
        check_solution(*solver, *next);
      }
      CHECK(solver->statistics().analyze_calls == 4);
      if (backend == Backend::pcg) continue;
      CHECK(solver->statistics().orderings == 1);
      ++direct;
    }
  CHECK(direct >= 1);
}

TEST_CASE("sparse solver: automatic keeps its choice and its ordering") {
  Options options;
  const auto solver = make_solver(options);
  REQUIRE(solver->analyze(coupled_grid(20, {})));
  const Backend chosen = solver->statistics().backend;
  for (const int far : {399, 200, 390}) {
    const SymmetricMatrix A = coupled_grid(20, {{0, far}});
    REQUIRE(solver->update_pattern(A));
    check_solution(*solver, A);
  }
  CHECK(solver->statistics().backend == chosen);
  CHECK(solver->statistics().orderings == 1);

  // Where a factorization is out of the question, conjugate gradients get the new pattern too.
  options.automatic_max_flops = 1e4;
  options.pcg_tolerance = 1e-10;
  const auto iterative = make_solver(options);
  SymmetricMatrix A = grid_3d(7);
  REQUIRE(iterative->analyze(A));
  REQUIRE(iterative->statistics().backend == Backend::pcg);
  Triplets springs;
  for (int j = 0; j < A.size; ++j)
    for (int k = A.column_start[j]; k < A.column_start[j + 1]; ++k) {
      springs.emplace_back(A.row[k], j, A.value[k]);
      if (A.row[k] != j) springs.emplace_back(j, A.row[k], A.value[k]);
    }
  add_edge(springs, 0, 342, 3, 5.0);
  const SymmetricMatrix coupled = finish(343, 3, 0, springs);
  REQUIRE(iterative->update_pattern(coupled));
  check_solution(*iterative, coupled);
  CHECK(iterative->statistics().backend == Backend::pcg);
}

TEST_CASE(
    "sparse solver: far couplings leave the ordering alone; where they are too many it is computed again") {
  const auto solver = make_solver();
  const int n = 20;
  std::vector<std::pair<int, int>> star, tangle;
  for (int i = 1; i < n * n; ++i) star.emplace_back(0, i);
  for (int i = 0; i < n * n; ++i)
    if (const int other = (37 * i + 11) % (n * n); other != i) tangle.emplace_back(i, other);
  REQUIRE(solver->analyze(coupled_grid(n, {})));
  check_solution(*solver, coupled_grid(n, {}));
  const double before = solver->statistics().factor_nonzeros;

  // The hub goes to the end: two full rows, and no more.
  REQUIRE(solver->update_pattern(coupled_grid(n, star)));
  check_solution(*solver, coupled_grid(n, star));
  CHECK(solver->statistics().factor_nonzeros <= before + 2 * 2 * n * n);
  CHECK(solver->statistics().orderings == 1);

  REQUIRE(solver->update_pattern(coupled_grid(n, tangle)));
  check_solution(*solver, coupled_grid(n, tangle));
  CHECK(solver->statistics().orderings == 2);
}

TEST_CASE("sparse solver: patterns that cannot be taken are refused") {
  const auto solver = make_solver({});
  const SymmetricMatrix A = grid_2d(5);
  CHECK_THROWS_WITH_AS(solver->update_pattern(A), doctest::Contains("needs an analyze() first"), Error);
  REQUIRE(solver->analyze(A));
  CHECK_THROWS_WITH_AS(solver->update_pattern(grid_2d(6)), doctest::Contains("size and groups stay"), Error);
  SymmetricMatrix ungrouped = A;
  ungrouped.group.clear();
  CHECK_THROWS_WITH_AS(solver->update_pattern(ungrouped), doctest::Contains("size and groups stay"), Error);
  SymmetricMatrix malformed = A;
  std::swap(malformed.row[1], malformed.row[2]);
  CHECK_THROWS_WITH_AS(solver->update_pattern(malformed), doctest::Contains("strictly increasing"), Error);
  check_solution(*solver, A);  // and leave it as it was
}

namespace {

// Hands everything to Eigen's factorization.
class Outsider final : public Solver {
 public:
  explicit Outsider(const Options& options) {
    Options inner = options;
    inner.backend = Backend::eigen_ldlt;
    inner_ = make_solver(inner);
  }

 private:
  FactorResult do_analyze(const SymmetricMatrix& A) override { return inner_->analyze(A); }
  FactorResult do_factorize(const SymmetricMatrix& A) override { return inner_->factorize(A); }
  SolveResult do_solve(const double* b, double* x, int columns) override {
    return inner_->solve_columns(b, x, columns);
  }

  std::unique_ptr<Solver> inner_;
};

}  // namespace

TEST_CASE("register_solver: a solver from outside goes by its name wherever a back end does") {
  const Backend backend =
      register_solver("outsider", [](const Options& options) { return std::make_unique<Outsider>(options); });
  CHECK(backend_name(backend) == "outsider");
  CHECK(backend_from_name("outsider") == backend);
  CHECK(is_available(backend));
  const auto backends = available_backends();
  CHECK(std::count(backends.begin(), backends.end(), backend) == 1);
  CHECK_THROWS_WITH_AS(backend_from_name("nobody"), doctest::Contains("pcg, outsider"), Error);

  Options options;
  options.backend = backend;
  const auto solver = make_solver(options);
  CHECK(solver->statistics().backend == backend);
  const SymmetricMatrix A = coupled_grid(8, {}), B = coupled_grid(8, {{0, 63}});
  REQUIRE(solver->analyze(A));
  check_solution(*solver, A);
  REQUIRE(solver->update_pattern(B));  // analyzed anew: it knows no better
  check_solution(*solver, B);
  CHECK(solver->statistics().analyze_calls == 2);

  const auto factory = [](const Options& given) { return std::make_unique<Outsider>(given); };
  for (const char* taken : {"outsider", "pcg", "automatic"})
    CHECK_THROWS_WITH_AS(register_solver(taken, factory),
                         ("register_solver: the name '" + std::string(taken) + "' is taken").c_str(), Error);
  CHECK_THROWS_WITH_AS(register_solver("", factory), "register_solver: the name is empty", Error);
  CHECK_THROWS_WITH_AS(register_solver("empty", {}), "register_solver: there is no factory for 'empty'",
                       Error);
  // What is registered stays, and other tests go through all back ends: it makes none just now.
  static bool makes_one = false;
  options.backend = register_solver("moody", [](const Options& given) -> std::unique_ptr<Solver> {
    if (!makes_one) return nullptr;
    return std::make_unique<Outsider>(given);
  });
  CHECK_THROWS_WITH_AS(make_solver(options), "the factory of the linear solver 'moody' made none", Error);
  makes_one = true;
  CHECK(make_solver(options) != nullptr);
}
