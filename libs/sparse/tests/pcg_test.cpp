// Conjugate gradients with every preconditioner, and the automatic choice between them and a factorization.
#include "elasticity.hpp"
#include "matrices.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/sparse/solver.hpp>

#include <doctest/doctest.h>

#if defined(_OPENMP)
#include <omp.h>
#endif

#include <cmath>
#include <limits>
#include <string>

using namespace isostretch;
using namespace isostretch::sparse;
using namespace isostretch::sparse::test;

namespace {

Options pcg(Preconditioner preconditioner, double tolerance = 1e-9) {
  Options options;
  options.backend = Backend::pcg;
  options.pcg_preconditioner = preconditioner;
  options.pcg_tolerance = tolerance;
  return options;
}

template <class Body>
void for_each_preconditioner(const Body& body) {
  for (const Preconditioner preconditioner : all_preconditioners()) {
    const std::string name(preconditioner_name(preconditioner));
    CAPTURE(name);
    body(preconditioner);
  }
}

ElasticBox box(int cells) {
  ElasticBox box;
  for (int& n : box.cells) n = cells;
  return box;
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

struct Solved {
  Eigen::VectorXd x;
  SolveResult result;
};

Solved solve(Solver& solver, const SymmetricMatrix& A, const Eigen::VectorXd& b) {
  const FactorResult factored = solver.factorize(A);
  REQUIRE_MESSAGE(factored, factored.message);
  Solved solved;
  solved.result = solver.solve(b, solved.x);
  return solved;
}

void check_solves(Solver& solver, const SymmetricMatrix& A, double tolerance = 1e-9) {
  const Eigen::VectorXd b = random_vector(A.size, 5);
  const Solved solved = solve(solver, A, b);
  CHECK_MESSAGE(solved.result, solved.result.message);
  CHECK(relative_residual(A, solved.x, b) <= 1.0001 * tolerance);
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
  CHECK(chosen(system.A) == available_backends().front());
  if (is_available(Backend::cholmod_supernodal)) {
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
  }
  options.automatic_max_flops = -1;
  CHECK_THROWS_WITH_AS(make_solver(options), doctest::Contains("automatic_max_flops"), Error);
  options = {};
  options.stale_max_iterations = -1;
  CHECK_THROWS_WITH_AS(make_solver(options), doctest::Contains("stale_max_iterations"), Error);
}

TEST_CASE("automatic back end: where multigrid does not converge, the matrix is factorised") {
  if (!is_available(Backend::cholmod_supernodal)) return;
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
  CHECK(solver->statistics().backend == Backend::cholmod_supernodal);
  check_solves(*solver, system.A);
  // A new analysis is a new chance.
  REQUIRE(solver->analyze(system.A));
  CHECK(solver->statistics().backend == Backend::pcg);
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

TEST_CASE("preconditioners: names go both ways") {
  for_each_preconditioner([](Preconditioner preconditioner) {
    CHECK(preconditioner_from_name(preconditioner_name(preconditioner)) == preconditioner);
  });
  CHECK_THROWS_WITH_AS(preconditioner_from_name("ilu"),
                       doctest::Contains("incomplete_cholesky, stale_cholesky, amg"), Error);
}
