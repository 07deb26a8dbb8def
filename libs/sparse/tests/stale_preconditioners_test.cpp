// Preconditioners that serve several matrices, and are made anew when they serve badly.
#include "elasticity.hpp"
#include "matrices.hpp"
#include "pcg.hpp"

#include <isostretch/sparse/solver.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>

using namespace isostretch::sparse;
using namespace isostretch::sparse::test;

TEST_CASE("stale preconditioners: slowly changing matrices share one, and solutions are as good") {
  SymmetricMatrix A = elastic_box(box(9)).A;
  for (const Preconditioner preconditioner : {Preconditioner::stale_cholesky, Preconditioner::amg}) {
    Options options = pcg(preconditioner);
    options.stale_max_iterations = preconditioner == Preconditioner::amg ? 40 : 12;
    const auto solver = make_solver(options);
    REQUIRE(solver->analyze(A));
    SymmetricMatrix changing = A;
    for (int round = 0; round < 8; ++round) {
      for (int j = 0; j < A.size; ++j)
        changing.value[changing.column_start[j]] += 0.01 * (1 + std::sin(j + round));
      check_solves(*solver, changing);
    }
    CHECK(solver->statistics().factorize_calls == 8);
    CHECK(solver->statistics().factorizations >= 1);
    CHECK(solver->statistics().factorizations <= 4);
  }
}

TEST_CASE("stale preconditioners: made anew when they serve badly, at once when very badly") {
  const SymmetricMatrix A = elastic_box(box(8)).A;
  ElasticBox other = box(8);
  other.contrast = 7;
  const SymmetricMatrix B = elastic_box(other).A;
  Options options = pcg(Preconditioner::stale_cholesky);
  options.stale_max_iterations = 10;
  const auto solver = make_solver(options);
  REQUIRE(solver->analyze(A));
  check_solves(*solver, A);
  CHECK(solver->statistics().factorizations == 1);
  const Eigen::VectorXd b = random_vector(A.size, 5);
  const Solved solved = solve(*solver, B, b);
  CHECK(solved.result);
  CHECK(solved.result.iterations <= 25);  // twice ten with the old factor, then a few with the new one
  CHECK(solver->statistics().factorizations == 2);
}

TEST_CASE("a preconditioner whose renewal failed is not used again: every column and solve says so") {
  SymmetricMatrix A = grid_2d(40), B = A;
  for (int j = 0; j < B.size; ++j)
    B.value[static_cast<std::size_t>(B.column_start[static_cast<std::size_t>(j)])] -= 0.05;
  for (const Preconditioner preconditioner : {Preconditioner::stale_cholesky, Preconditioner::amg}) {
    CAPTURE(preconditioner_name(preconditioner));
    Options options = pcg(preconditioner);
    options.stale_max_iterations = 1;
    const auto solver = make_solver(options);
    REQUIRE(solver->analyze(A));
    REQUIRE(solver->factorize(A));
    REQUIRE(solver->factorize(B));
    const Eigen::MatrixXd b = Eigen::MatrixXd::Ones(A.size, 2);
    Eigen::MatrixXd x;
    for (int again = 0; again < 2; ++again) {
      const SolveResult result = solver->solve(b, x);
      CHECK(result.status == SolveStatus::not_positive_definite);
      CHECK(x.allFinite());
    }
    REQUIRE(solver->factorize(A));
    CHECK(solver->solve(b, x));
  }
}
