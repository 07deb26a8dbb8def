// One suite for every back end that is compiled in.
#include "every_solver.hpp"
#include "matrices.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/sparse/solver.hpp>

#include <doctest/doctest.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace isostretch;
using namespace isostretch::sparse;
using namespace isostretch::sparse::test;

namespace {

void check_solves(Solver& solver, const SymmetricMatrix& A, unsigned seed, double tolerance = 1e-10) {
  const FactorResult factored = solver.factorize(A);
  REQUIRE_MESSAGE(factored, factored.message);
  const Eigen::VectorXd b = random_vector(A.size, seed);
  Eigen::VectorXd x;
  const SolveResult solved = solver.solve(b, x);
  CHECK_MESSAGE(solved, solved.message);
  CHECK(relative_residual(A, x, b) < tolerance);
}

void check_matrix(const SymmetricMatrix& A) {
  for_each_solver([&](const Options& options) {
    const auto solver = make_solver(options);
    REQUIRE(solver->analyze(A));
    check_solves(*solver, A, 7);
  });
}

SymmetricMatrix diagonal(std::vector<double> values) {
  SymmetricMatrix A;
  A.size = static_cast<int>(values.size());
  for (int j = 0; j < A.size; ++j) A.row.push_back(j);
  for (int j = 0; j <= A.size; ++j) A.column_start.push_back(j);
  A.value = std::move(values);
  return A;
}

}  // namespace

TEST_CASE("sparse solver: random matrices") {
  check_matrix(random_spd(1, 0, 1));
  check_matrix(random_spd(13, 2, 2));
  check_matrix(random_spd(300, 4, 3));
}

TEST_CASE("sparse solver: block Laplacians in 2D and 3D, with groups and without") {
  SymmetricMatrix A = grid_2d(23);
  check_matrix(A);
  A.group.clear();
  check_matrix(A);
  A = grid_3d(7);
  check_matrix(A);
  A.group.clear();
  check_matrix(A);
}

TEST_CASE("sparse solver: groups of different sizes with gaps in the numbering") {
  SymmetricMatrix A = random_spd(60, 3, 4);
  for (int i = 0; i < A.size; ++i) A.group.push_back(i < 5 ? 2 : 10 + 3 * (i / 4));
  check_matrix(A);
}

TEST_CASE("sparse solver: empty system") {
  for_each_solver([](const Options& options) {
    const auto solver = make_solver(options);
    const SymmetricMatrix A = diagonal({});
    CHECK(solver->analyze(A));
    CHECK(solver->factorize(A));
    Eigen::VectorXd x = Eigen::VectorXd::Ones(3);
    CHECK(solver->solve(Eigen::VectorXd(0), x));
    CHECK(x.size() == 0);
  });
}

TEST_CASE("sparse solver: 1x1") {
  for_each_solver([](const Options& options) {
    const auto solver = make_solver(options);
    solver->analyze(diagonal({4.0}));
    REQUIRE(solver->factorize(diagonal({4.0})));
    Eigen::VectorXd x;
    CHECK(solver->solve(Eigen::VectorXd::Constant(1, 2.0), x));
    CHECK(x[0] == doctest::Approx(0.5));
    for (const double bad : {0.0, -1.0}) {
      const FactorResult result = solver->factorize(diagonal({bad}));
      CHECK(result.status == FactorStatus::not_positive_definite);
      CHECK(result.column == 0);
      CHECK_THROWS_WITH_AS(solver->solve(Eigen::VectorXd::Ones(1), x), doctest::Contains("factorize()"),
                           Error);
    }
    CHECK(solver->factorize(diagonal({2.0})));
  });
}

TEST_CASE("sparse solver: new values in the pattern analyzed") {
  for_each_solver([](const Options& options) {
    SymmetricMatrix A = grid_2d(11);
    const auto solver = make_solver(options);
    solver->analyze(A);
    for (int round = 0; round < 4; ++round) {
      for (double& v : A.value) v *= 1.7;
      for (int j = round; j < A.size; j += 3) diagonal_entry(A, j) += 1.0;
      check_solves(*solver, A, 20 + round);
    }
    CHECK(solver->statistics().analyze_calls == 1);
    CHECK(solver->statistics().factorize_calls == 4);
    CHECK(solver->statistics().solve_calls == 4);
  });
}

TEST_CASE("sparse solver: one solver for one pattern after another") {
  for_each_solver([](const Options& options) {
    const auto solver = make_solver(options);
    for (const SymmetricMatrix& A : {grid_2d(9), grid_3d(4), random_spd(50, 3, 5)}) {
      solver->analyze(A);
      check_solves(*solver, A, 31);
    }
  });
}

TEST_CASE("sparse solver: indefinite matrix is a status, and the next matrix is solved") {
  for_each_solver([](const Options& options) {
    SymmetricMatrix A = grid_2d(15);
    const auto solver = make_solver(options);
    solver->analyze(A);
    for (const int bad : {0, 101, A.size - 1}) {
      const double good = diagonal_entry(A, bad);
      diagonal_entry(A, bad) = -3.0;
      const FactorResult result = solver->factorize(A);
      CHECK(result.status == FactorStatus::not_positive_definite);
      CHECK_FALSE(result.message.empty());
      // A pivot only decreases during elimination: the bad column is the first that can fail, or its
      // neighbours.
      CHECK(result.column >= 0);
      CHECK(result.column < A.size);
      diagonal_entry(A, bad) = good;
      check_solves(*solver, A, 40);
    }
  });
}

TEST_CASE("sparse solver: the failing column is in the caller's numbering") {
  for_each_solver([](const Options& options) {
    std::vector<double> values(50, 1.0);
    values[37] = -1.0;
    const auto solver = make_solver(options);
    solver->analyze(diagonal(values));
    CHECK(solver->factorize(diagonal(values)).column == 37);
  });
}

TEST_CASE("sparse solver: hidden indefiniteness (positive diagonal) then a shift") {
  for_each_solver([](const Options& options) {
    SymmetricMatrix A = grid_2d(12, -0.05);  // smallest eigenvalue -0.05 * (constant vectors)
    const auto solver = make_solver(options);
    solver->analyze(A);
    const FactorResult result = solver->factorize(A);
    if (options.backend == Backend::pcg) {
      REQUIRE(result);
      Eigen::VectorXd x;
      const SolveResult solved = solver->solve(Eigen::VectorXd::Ones(A.size), x);
      CHECK(solved.status == SolveStatus::not_positive_definite);
      CHECK(solved.message.find("negative curvature") != std::string::npos);
    } else {
      CHECK(result.status == FactorStatus::not_positive_definite);
    }
    for (int j = 0; j < A.size; ++j) diagonal_entry(A, j) += 0.1;
    check_solves(*solver, A, 41);
  });
}

TEST_CASE("sparse solver: condition number 1e12") {
  for_each_solver([](const Options& options) {
    SymmetricMatrix A = grid_2d(14, 1e-2);
    Eigen::VectorXd scale(A.size);
    for (int i = 0; i < A.size; ++i) scale[i] = std::pow(10.0, -4.5 * i / (A.size - 1));
    for (int j = 0; j < A.size; ++j)
      for (int k = A.column_start[j]; k < A.column_start[j + 1]; ++k)
        A.value[k] *= scale[j] * scale[A.row[k]];
    const auto solver = make_solver(options);
    solver->analyze(A);
    REQUIRE(solver->factorize(A));
    const Eigen::VectorXd b = A.multiply(random_vector(A.size, 8));
    Eigen::VectorXd x;
    const SolveResult solved = solver->solve(b, x);
    const double residual = relative_residual(A, x, b);
    if (options.backend == Backend::pcg)
      CHECK(solved.relative_residual == doctest::Approx(residual).epsilon(1e-6));  // honest, whatever it is
    else
      CHECK(residual < 1e-13);
  });
}

TEST_CASE("sparse solver: several right-hand sides") {
  for_each_solver([](const Options& options) {
    const SymmetricMatrix A = grid_3d(5);
    const auto solver = make_solver(options);
    solver->analyze(A);
    REQUIRE(solver->factorize(A));
    Eigen::MatrixXd B(A.size, 3), X;
    for (int c = 0; c < 3; ++c) B.col(c) = random_vector(A.size, 60 + c);
    CHECK(solver->solve(B, X));
    for (int c = 0; c < 3; ++c) {
      Eigen::VectorXd x;
      solver->solve(B.col(c), x);
      CHECK((X.col(c) - x).norm() < 1e-12 * x.norm());
      CHECK(relative_residual(A, X.col(c), B.col(c)) < 1e-10);
    }
    Eigen::MatrixXd none;
    CHECK(solver->solve(Eigen::MatrixXd(A.size, 0), none));
    CHECK(none.cols() == 0);
  });
}

TEST_CASE("sparse solver: renumbering the unknowns renumbers the solution") {
  const SymmetricMatrix A = grid_2d(10);
  const int n = A.size;
  std::vector<int> shuffled(n);
  for (int i = 0; i < n; ++i) shuffled[i] = static_cast<int>((i * 37LL + 11) % n);
  Triplets triplets;
  for (int j = 0; j < n; ++j)
    for (int k = A.column_start[j]; k < A.column_start[j + 1]; ++k) {
      triplets.emplace_back(shuffled[A.row[k]], shuffled[j], A.value[k]);
      if (A.row[k] != j) triplets.emplace_back(shuffled[j], shuffled[A.row[k]], A.value[k]);
    }
  const SymmetricMatrix B = from_triplets(n, triplets);
  const Eigen::VectorXd b = random_vector(n, 70);
  Eigen::VectorXd shuffled_b(n);
  for (int i = 0; i < n; ++i) shuffled_b[shuffled[i]] = b[i];
  for_each_solver([&](const Options& options) {
    const auto solution = [&](const SymmetricMatrix& matrix, const Eigen::VectorXd& rhs) {
      const auto solver = make_solver(options);
      solver->analyze(matrix);
      REQUIRE(solver->factorize(matrix));
      Eigen::VectorXd z;
      CHECK(solver->solve(rhs, z));
      return z;
    };
    const Eigen::VectorXd x = solution(A, b), y = solution(B, shuffled_b);
    for (int i = 0; i < n; ++i) CHECK(y[shuffled[i]] == doctest::Approx(x[i]).epsilon(1e-6));
  });
}

TEST_CASE("sparse solver: misuse is refused by name") {
  for_each_solver([](const Options& options) {
    const auto solver = make_solver(options);
    SymmetricMatrix A = grid_2d(4);
    Eigen::VectorXd x;
    CHECK_THROWS_WITH_AS(solver->factorize(A), doctest::Contains("analyze()"), Error);
    SymmetricMatrix no_diagonal{2, {0, 1, 1}, {0}, {1.0}, {}};
    CHECK_THROWS_WITH_AS(solver->analyze(no_diagonal), doctest::Contains("no diagonal entry in column 1"),
                         Error);
    solver->analyze(A);
    CHECK_THROWS_WITH_AS(solver->factorize(grid_2d(5)),
                         doctest::Contains("size 50 after analyze() of size 32"), Error);
    SymmetricMatrix other = A;
    ++other.row[other.column_start[1] - 1];
    CHECK_THROWS_WITH_AS(solver->factorize(other), doctest::Contains("pattern"), Error);
    SymmetricMatrix nan = A;
    nan.value[nan.column_start[3] + 1] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH_AS(solver->factorize(nan), doctest::Contains("NaN at row"), Error);
    REQUIRE(solver->factorize(A));
    CHECK_THROWS_WITH_AS(solver->solve(Eigen::VectorXd::Ones(3), x),
                         doctest::Contains("3 rows, the matrix 32"), Error);
    Eigen::VectorXd b = Eigen::VectorXd::Ones(A.size);
    b[5] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH_AS(solver->solve(b, x), doctest::Contains("not finite in row 5"), Error);
    CHECK_THROWS_AS(solver->factorize(nan), Error);
    CHECK_THROWS_AS(solver->solve(Eigen::VectorXd::Ones(A.size), x), Error);  // no stale factor is used
    check_solves(*solver, A, 3);
  });
}

TEST_CASE("sparse solver: options out of range are refused") {
  Options options;
  options.pcg_tolerance = 0;
  CHECK_THROWS_WITH_AS(make_solver(options), doctest::Contains("pcg_tolerance"), Error);
  options = {};
  options.pcg_max_iterations = -1;
  CHECK_THROWS_WITH_AS(make_solver(options), doctest::Contains("pcg_max_iterations"), Error);
  for (const Backend backend : {Backend::cholmod_supernodal, Backend::cholmod_simplicial})
    if (!is_available(backend)) {
      options = {};
      options.backend = backend;
      CHECK_THROWS_WITH_AS(make_solver(options), doctest::Contains("not compiled in"), Error);
    }
}

TEST_CASE("sparse solver: statistics say what was done") {
  for (const SymmetricMatrix& A : {grid_2d(20), grid_3d(6)}) {
    const auto solver = make_solver();
    solver->analyze(A);
    check_solves(*solver, A, 1);
    const Statistics& s = solver->statistics();
    CHECK(s.backend != Backend::automatic);
    CHECK(s.ordering != Ordering::automatic);
    CHECK(s.factor_nonzeros >= A.nonzeros());
    if (s.backend == Backend::multifrontal) CHECK(s.factor_bytes >= 8 * s.factor_nonzeros);
    CHECK(s.analyze_seconds > 0);
    CHECK(s.ordering_seconds <= s.analyze_seconds);
    CHECK(s.factorize_seconds > 0);
    CHECK(s.solve_seconds > 0);
  }
}

TEST_CASE("sparse solver: a fill-reducing ordering on groups has far less fill than none") {
  const SymmetricMatrix A = grid_2d(40);
  const auto fill = [&](Ordering ordering) {
    Options options;
    options.backend = Backend::eigen_ldlt;
    options.ordering = ordering;
    const auto solver = make_solver(options);
    solver->analyze(A);
    solver->factorize(A);
    return solver->statistics().factor_nonzeros;
  };
  CHECK(fill(Ordering::amd) < 0.5 * fill(Ordering::natural));
}
