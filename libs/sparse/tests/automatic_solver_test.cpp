// What the automatic back end and ordering choose.
#include "elasticity.hpp"
#include "matrices.hpp"
#include "pcg.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/sparse/solver.hpp>

#include <doctest/doctest.h>

#include <algorithm>

using namespace isostretch;
using namespace isostretch::sparse;
using namespace isostretch::sparse::test;

TEST_CASE("automatic back end: factorizations as far as they pay, then multigrid; never in 2D") {
  const ElasticSystem system = elastic_box(box(8));
  Options options;
  const auto chosen = [&](const SymmetricMatrix& A) {
    const auto solver = make_solver(options);
    solver->set_coordinates(system.coords.data(), 3, system.nodes);
    solver->set_tolerance(1e-9);
    REQUIRE(solver->analyze(A));
    check_solves(*solver, A);
    CHECK(solver->statistics().factorizations == 1);
    return solver->statistics().backend;
  };
  CHECK(chosen(system.A) == Backend::multifrontal);
  CHECK(available_backends().front() == Backend::multifrontal);
  options.automatic_max_flops = 1e6;
  CHECK(chosen(system.A) == Backend::pcg);
  const auto flat = make_solver(options);
  flat->analyze(grid_2d(30));
  CHECK(flat->statistics().backend != Backend::pcg);
  // One solver for one pattern after the other.
  flat->analyze(system.A);
  check_solves(*flat, system.A, 1e-8);
  CHECK(flat->statistics().backend == Backend::pcg);
  CHECK(flat->statistics().preconditioner == Preconditioner::amg);
  CHECK(flat->statistics().multiplications > 0);
  options.automatic_max_flops = -1;
  CHECK_THROWS_WITH_AS(make_solver(options), doctest::Contains("automatic_max_flops"), Error);
  options = {};
  options.stale_max_iterations = -1;
  CHECK_THROWS_WITH_AS(make_solver(options), doctest::Contains("stale_max_iterations"), Error);
}

TEST_CASE("automatic back end: where multigrid does not converge, the matrix is factorised") {
  const ElasticSystem system = elastic_box(box(8));
  Options options;
  options.automatic_max_flops = 1e6;
  options.pcg_max_iterations = 2;
  const auto solver = make_solver(options);
  REQUIRE(solver->analyze(system.A));
  REQUIRE(solver->factorize(system.A));
  CHECK(solver->statistics().backend == Backend::pcg);
  Eigen::VectorXd x;
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(system.A.size);
  CHECK(solver->solve(b, x));
  CHECK((system.A.multiply(x) - b).norm() <= 1e-9 * b.norm());
  CHECK(solver->statistics().backend == Backend::multifrontal);
  check_solves(*solver, system.A);
  // A new analysis is a new chance.
  REQUIRE(solver->analyze(system.A));
  CHECK(solver->statistics().backend == Backend::pcg);
}

TEST_CASE("sparse solver: automatic ordering tells 3D from 2D") {
  const auto chosen = [](const SymmetricMatrix& A) {
    const auto solver = make_solver();
    solver->analyze(A);
    return solver->statistics().ordering;
  };
  CHECK(chosen(grid_2d(40)) == Ordering::amd);
  CHECK(chosen(grid_3d(5)) == Ordering::amd);  // too small to matter
  const auto& orderings = available_orderings();
  const bool metis = std::find(orderings.begin(), orderings.end(), Ordering::metis) != orderings.end();
  CHECK(chosen(grid_3d(11)) == (metis ? Ordering::metis : Ordering::amd));
}
