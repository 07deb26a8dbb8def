// Conjugate gradients whatever their preconditioner: tolerances, limits, and solutions that are cut off.
#include "elasticity.hpp"
#include "matrices.hpp"
#include "pcg.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/sparse/solver.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::sparse;
using namespace isostretch::sparse::test;

TEST_CASE("conjugate gradients: the tolerance can be set between solves") {
  const SymmetricMatrix A = grid_3d(8);
  const auto solver = make_solver(pcg(Preconditioner::block_jacobi));
  solver->set_tolerance(1e-2);
  solver->analyze(A);
  const Eigen::VectorXd b = random_vector(A.size, 9);
  const Solved loose = solve(*solver, A, b);
  CHECK(loose.result.relative_residual <= 1e-2);
  CHECK(loose.result.relative_residual > 1e-4);
  solver->set_tolerance(1e-10);
  const Solved tight = solve(*solver, A, b);
  CHECK(tight.result.relative_residual <= 1e-10);
  CHECK(tight.result.iterations > loose.result.iterations);
  for (const double bad : {0.0, 1.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_WITH_AS(solver->set_tolerance(bad), doctest::Contains("between 0 and 1"), Error);
  const auto direct = make_solver();
  direct->set_tolerance(0.5);
  direct->analyze(A);
  CHECK(relative_residual(A, solve(*direct, A, b).x, b) < 1e-12);
}

TEST_CASE("conjugate gradients: truncated solutions are directions of descent") {
  ElasticBox broken = box(8);
  const SymmetricMatrix good = elastic_box(broken).A;
  SymmetricMatrix bad = good;  // indefinite only a little
  for (int j = 0; j < bad.size; ++j) bad.value[bad.column_start[j]] -= 0.01;
  const Eigen::VectorXd b = random_vector(good.size, 10);
  Eigen::VectorXd x;
  const auto solver = make_solver(pcg(Preconditioner::block_jacobi));
  solver->analyze(good);
  REQUIRE(solver->factorize(bad));
  const SolveResult curved = solver->solve(b, x);
  CHECK(curved.status == SolveStatus::not_positive_definite);
  CHECK(curved.iterations > 1);
  CHECK(b.dot(x) > 0);
  CHECK(0.5 * x.dot(bad.multiply(x)) - b.dot(x) < 0);
  // On the diagonal alone all is well; the first direction already sees the rest.
  const SymmetricMatrix first{2, {0, 2, 3}, {0, 1, 1}, {1, -3, 1}, {}};
  const auto small = make_solver(pcg(Preconditioner::jacobi));
  small->analyze(first);
  REQUIRE(small->factorize(first));
  CHECK(small->solve(Eigen::VectorXd::Ones(2), x).status == SolveStatus::not_positive_definite);
  CHECK(x.isZero(0));

  Options few = pcg(Preconditioner::amg);
  few.pcg_max_iterations = 3;
  const auto limited = make_solver(few);
  limited->analyze(good);
  const Solved solved = solve(*limited, good, b);
  CHECK(solved.result.status == SolveStatus::not_converged);
  CHECK(solved.result.iterations == 3);
  CHECK(0.5 * solved.x.dot(good.multiply(solved.x)) - b.dot(solved.x) < 0);
}

TEST_CASE("conjugate gradients: coordinates that do not fit are refused") {
  const ElasticSystem system = elastic_box(box(2));
  const auto refused = [&](int dim, int nodes, const std::vector<int>& axis, const char* message) {
    const auto solver = make_solver(pcg(Preconditioner::amg));
    CHECK_THROWS_WITH_AS(
        (solver->set_coordinates(system.coords.data(), dim, nodes, axis), solver->analyze(system.A)),
        doctest::Contains(message), Error);
  };
  refused(4, 3, {}, "dimension 4");
  refused(3, -1, {}, "-1 nodes");
  refused(3, system.nodes - 1, {}, "coordinates of 26 nodes, but groups from 9 to 26");
  refused(3, system.nodes, {0, 1}, "2 axes for 54 unknowns");
  refused(3, system.nodes, std::vector<int>(54, 0), "axis 0 of unknown 1 does not follow");
  refused(3, system.nodes, std::vector<int>(54, 3), "axis 3 of unknown 0 is outside");
  std::vector<double> bad = system.coords;
  bad[7] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS(make_solver()->set_coordinates(bad.data(), 3, system.nodes),
                       doctest::Contains("node 2 is not finite"), Error);
}

TEST_CASE("conjugate gradients: converge with both preconditioners, block-Jacobi no slower") {
  SymmetricMatrix A = grid_2d(30, 1e-4);
  int iterations[2] = {0, 0};
  for (const Preconditioner kind : {Preconditioner::jacobi, Preconditioner::block_jacobi}) {
    Options options;
    options.backend = Backend::pcg;
    options.pcg_preconditioner = kind;
    const auto solver = make_solver(options);
    solver->analyze(A);
    REQUIRE(solver->factorize(A));
    const Eigen::VectorXd b = random_vector(A.size, 9);
    Eigen::VectorXd x;
    const SolveResult result = solver->solve(b, x);
    CHECK(result);
    CHECK(result.relative_residual <= options.pcg_tolerance);
    CHECK(relative_residual(A, x, b) <= options.pcg_tolerance);
    iterations[static_cast<int>(kind)] = result.iterations;
  }
  CHECK(iterations[1] <= iterations[0]);
}

TEST_CASE("conjugate gradients: report when they do not converge") {
  const SymmetricMatrix A = grid_2d(30, 1e-4);
  Options options;
  options.backend = Backend::pcg;
  options.pcg_max_iterations = 5;
  const auto solver = make_solver(options);
  solver->analyze(A);
  solver->factorize(A);
  Eigen::VectorXd x;
  const SolveResult result = solver->solve(random_vector(A.size, 9), x);
  CHECK(result.status == SolveStatus::not_converged);
  CHECK(result.iterations == 5);
  CHECK(result.message.find("iteration limit after 5 iterations") != std::string::npos);
  CHECK(x.allFinite());
  // A tolerance below what rounding allows ends by itself, long before the default limit.
  options.pcg_max_iterations = 0;
  options.pcg_tolerance = 1e-17;
  const auto strict = make_solver(options);
  strict->analyze(A);
  strict->factorize(A);
  const SolveResult stuck = strict->solve(random_vector(A.size, 9), x);
  CHECK(stuck.status == SolveStatus::not_converged);
  CHECK(stuck.relative_residual < 1e-10);
}

TEST_CASE("conjugate gradients: zero right-hand side") {
  Options options;
  options.backend = Backend::pcg;
  const SymmetricMatrix A = grid_2d(5);
  const auto solver = make_solver(options);
  solver->analyze(A);
  solver->factorize(A);
  Eigen::VectorXd x;
  CHECK(solver->solve(Eigen::VectorXd::Zero(A.size), x));
  CHECK(x.isZero(0));
}
