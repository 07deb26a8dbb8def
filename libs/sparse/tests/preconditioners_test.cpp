// Every preconditioner of conjugate gradients, on matrices of every kind.
#include "elasticity.hpp"
#include "matrices.hpp"
#include "pcg.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/sparse/solver.hpp>

#include <doctest/doctest.h>

#if defined(_OPENMP)
#include <omp.h>
#endif

#include <limits>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::sparse;
using namespace isostretch::sparse::test;

namespace {

template <class Body>
void for_each_preconditioner(const Body& body) {
  for (const Preconditioner preconditioner : all_preconditioners()) {
    const std::string name(preconditioner_name(preconditioner));
    CAPTURE(name);
    body(preconditioner);
  }
}

std::vector<int> axes(const ElasticSystem& system, const ElasticBox& box) {
  std::vector<int> axis;
  const int slide_row = box.cells[1] + 1, depth = box.cells[2] + 1;
  for (int i = 0; i < system.A.size; ++i) {
    const int node = system.A.group[i];
    int a = i > 0 && system.A.group[i - 1] == node ? axis.back() + 1 : 0;
    if (box.rollers && node / depth % slide_row == 0 && node % 3 != 0 && a == 1) ++a;
    axis.push_back(a);
  }
  return axis;
}

void check_all(const SymmetricMatrix& A) {
  for_each_preconditioner([&](Preconditioner preconditioner) {
    const auto solver = make_solver(pcg(preconditioner));
    REQUIRE(solver->analyze(A));
    check_solves(*solver, A);
  });
}

void set_threads([[maybe_unused]] int threads) {
#if defined(_OPENMP)
  omp_set_num_threads(threads);
#endif
}

bool indefinite(Solver& solver, const SymmetricMatrix& A) {
  const FactorResult factored = solver.factorize(A);
  if (!factored) return factored.status == FactorStatus::not_positive_definite;
  Eigen::VectorXd x;
  return solver.solve(random_vector(A.size, 5), x).status == SolveStatus::not_positive_definite;
}

}  // namespace

TEST_CASE("preconditioners: one, two and three unknowns a node, groups too large for a block") {
  check_all(random_spd(700, 4, 3));
  check_all(grid_2d(30));
  check_all(grid_3d(8));
  SymmetricMatrix A = random_spd(300, 3, 4);
  for (int i = 0; i < A.size; ++i) A.group.push_back(i < 5 ? 2 : 10 + 3 * (i / 5));
  check_all(A);
}

TEST_CASE("preconditioners: diagonal matrices, and single unknowns") {
  check_all({1, {0, 1}, {0}, {3.0}, {}});
  SymmetricMatrix A;
  A.size = 2000;
  A.column_start.push_back(0);
  for (int i = 0; i < A.size; ++i) {
    A.row.push_back(i);
    A.value.push_back(1.0 + i);
    A.column_start.push_back(i + 1);
  }
  check_all(A);
}

TEST_CASE("preconditioners: elasticity with pins that leave nodes one, two or three unknowns") {
  ElasticBox elastic = box(7);
  elastic.rollers = true;
  const ElasticSystem system = elastic_box(elastic);
  check_all(system.A);
  for_each_preconditioner([&](Preconditioner preconditioner) {
    for (const bool with_axes : {false, true}) {
      const auto solver = make_solver(pcg(preconditioner));
      solver->set_coordinates(system.coords.data(), 3, system.nodes,
                              with_axes ? axes(system, elastic) : std::vector<int>{});
      REQUIRE(solver->analyze(system.A));
      check_solves(*solver, system.A);
    }
  });
}

TEST_CASE("preconditioners: ill-conditioned elasticity") {
  ElasticBox incompressible = box(7), flat = box(7), rough = box(7);
  incompressible.poisson = 0.495;
  flat.size[2] = 0.05;
  rough.contrast = 6;
  for (const ElasticBox& elastic : {incompressible, flat, rough}) {
    const ElasticSystem system = elastic_box(elastic);
    for_each_preconditioner([&](Preconditioner preconditioner) {
      const auto solver = make_solver(pcg(preconditioner, 1e-8));
      solver->set_coordinates(system.coords.data(), 3, system.nodes);
      REQUIRE(solver->analyze(system.A));
      check_solves(*solver, system.A, 1e-8);
    });
  }
}

TEST_CASE("preconditioners: values near the ends of the range") {
  for (const double factor : {1e-150, 1e150}) {
    SymmetricMatrix A = grid_3d(7);
    for (double& v : A.value) v *= factor;
    check_all(A);
  }
}

TEST_CASE("preconditioners: an indefinite matrix is a status, and the next one is solved") {
  ElasticBox broken = box(8);
  broken.negative_part = -2.5;
  const SymmetricMatrix good = elastic_box(box(8)).A, bad = elastic_box(broken).A;
  for_each_preconditioner([&](Preconditioner preconditioner) {
    const auto solver = make_solver(pcg(preconditioner));
    REQUIRE(solver->analyze(good));
    CHECK(indefinite(*solver, bad));
    check_solves(*solver, good);
    CHECK(indefinite(*solver, bad));  // also with the preconditioner of the good one
    check_solves(*solver, good);
    SymmetricMatrix nan = good;
    nan.value[77] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH_AS(solver->factorize(nan), doctest::Contains("NaN at row"), Error);
    check_solves(*solver, good);
  });
}

TEST_CASE("preconditioners: a semidefinite matrix does no harm") {
  SymmetricMatrix A = grid_3d(8, 0.0);
  for_each_preconditioner([&](Preconditioner preconditioner) {
    const auto solver = make_solver(pcg(preconditioner));
    REQUIRE(solver->analyze(A));
    if (!solver->factorize(A)) return;
    Eigen::VectorXd x;
    solver->solve(A.multiply(random_vector(A.size, 6)), x);
    CHECK(x.allFinite());
  });
}

TEST_CASE("preconditioners: the same bits for any number of threads") {
  const ElasticSystem system = elastic_box(box(26));  // large enough for several chunks and all loops
  const Eigen::VectorXd b = random_vector(system.A.size, 7);
  for_each_preconditioner([&](Preconditioner preconditioner) {
    if (preconditioner == Preconditioner::stale_cholesky) return;  // serial apart from BLAS
    Eigen::VectorXd first;
    for (const int threads : {1, 2, 3}) {
      set_threads(threads);
      const auto solver = make_solver(pcg(preconditioner, 1e-3));
      solver->set_coordinates(system.coords.data(), 3, system.nodes);
      solver->analyze(system.A);
      const Solved solved = solve(*solver, system.A, b);
      if (threads == 1) first = solved.x;
      CHECK(solved.x == first);
    }
  });
  set_threads(2);
}

TEST_CASE("preconditioners: better ones take fewer iterations, and coordinates help") {
  ElasticBox bar = box(5);
  bar.cells[0] = 60;
  const ElasticSystem system = elastic_box(bar);
  const Eigen::VectorXd b = random_vector(system.A.size, 8);
  const auto iterations = [&](Preconditioner preconditioner, bool coordinates) {
    const auto solver = make_solver(pcg(preconditioner, 1e-6));
    if (coordinates) solver->set_coordinates(system.coords.data(), 3, system.nodes);
    solver->analyze(system.A);
    const Solved solved = solve(*solver, system.A, b);
    CHECK(solved.result);
    CHECK(solver->statistics().multiplications == solved.result.iterations);
    CHECK(solver->statistics().factorizations == 1);
    CHECK(solver->statistics().preconditioner == preconditioner);
    return solved.result.iterations;
  };
  const int block_jacobi = iterations(Preconditioner::block_jacobi, false);
  const int incomplete = iterations(Preconditioner::incomplete_cholesky, false);
  const int amg = iterations(Preconditioner::amg, false);
  const int amg_with_rotations = iterations(Preconditioner::amg, true);
  CHECK(block_jacobi <= iterations(Preconditioner::jacobi, false));
  CHECK(2 * incomplete < block_jacobi);
  CHECK(amg < incomplete);
  CHECK(2 * amg_with_rotations < amg);
  CHECK(amg_with_rotations < 30);
  CHECK(iterations(Preconditioner::stale_cholesky, false) <= 2);
}

TEST_CASE("preconditioners: names go both ways") {
  for_each_preconditioner([](Preconditioner preconditioner) {
    CHECK(preconditioner_from_name(preconditioner_name(preconditioner)) == preconditioner);
  });
  CHECK_THROWS_WITH_AS(preconditioner_from_name("ilu"),
                       doctest::Contains("incomplete_cholesky, stale_cholesky, amg"), Error);
}
