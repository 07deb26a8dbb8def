// Unknowns that are eliminated last: what changes between factorizations, and Schur complements.
#include "every_solver.hpp"
#include "matrices.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/sparse/solver.hpp>

#include <doctest/doctest.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <random>
#include <vector>

using namespace isostretch;
using namespace isostretch::sparse;
using namespace isostretch::sparse::test;

namespace {

// Some unknowns of nodes, not always all that a node has, in no order.
std::vector<int> some_unknowns(const SymmetricMatrix& A, int count) {
  std::vector<int> all(static_cast<std::size_t>(A.size));
  for (int i = 0; i < A.size; ++i) all[i] = i;
  std::shuffle(all.begin(), all.end(), std::mt19937(5));
  all.resize(static_cast<std::size_t>(std::min(count, A.size)));
  return all;
}

// Adds to the diagonal and to no entry else, of these unknowns alone.
SymmetricMatrix stiffened(SymmetricMatrix A, const std::vector<int>& unknowns, double by) {
  for (const int unknown : unknowns) A.value[A.column_start[unknown]] += by;
  return A;
}

Eigen::MatrixXd dense(const SymmetricMatrix& A) {
  Eigen::MatrixXd result(A.size, A.size);
  for (int j = 0; j < A.size; ++j) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(A.size, j);
    result.col(j) = A.multiply(unit);
  }
  return result;
}

}  // namespace

TEST_CASE("last unknowns: refactorizations solve the matrix that they are given, with every solver") {
  for (const SymmetricMatrix& A : {grid_2d(23), random_spd(200, 4, 3)})
    for_each_solver([&](const Options& options) {
      const auto solver = make_solver(options);
      const std::vector<int> last = some_unknowns(A, 17);
      solver->set_last(last);
      REQUIRE(solver->analyze(A));
      REQUIRE(solver->refactorize(A));
      for (const double by : {0.5, 1e3, 0.0}) {
        const SymmetricMatrix changed = stiffened(A, last, by);
        const FactorResult result = solver->refactorize(changed);
        REQUIRE_MESSAGE(result, result.message);
        const Eigen::VectorXd b = random_vector(A.size, 4);
        Eigen::VectorXd x;
        REQUIRE(solver->solve(b, x));
        CHECK(relative_residual(changed, x, b) < 1e-10);
      }
    });
}

TEST_CASE(
    "last unknowns: a refactorization with the multifrontal back end gives the bits of a factorization") {
  const SymmetricMatrix A = grid_2d(40);
  const std::vector<int> last = some_unknowns(A, 30);
  const SymmetricMatrix changed = stiffened(A, last, 7);
  const Eigen::VectorXd b = random_vector(A.size, 4);
  for (const Backend backend : {Backend::multifrontal, Backend::automatic}) {
    Options options;
    options.backend = backend;
    const auto kept = make_solver(options), anew = make_solver(options);
    for (const auto& solver : {kept.get(), anew.get()}) {
      solver->set_last(last);
      REQUIRE(solver->analyze(A));
    }
    Eigen::VectorXd x, y;
    REQUIRE(kept->factorize(A));
    REQUIRE(kept->refactorize(changed));
    REQUIRE(anew->factorize(changed));
    REQUIRE(kept->solve(b, x));
    REQUIRE(anew->solve(b, y));
    CHECK((x.array() == y.array()).all());
  }
}

TEST_CASE("last unknowns: the Schur complement is that of the dense matrix, in their order") {
  for (const SymmetricMatrix& A : {grid_2d(15), random_spd(80, 3, 2)})
    for (const int count : {1, 13, A.size}) {
      const std::vector<int> last = some_unknowns(A, count);
      Options options;
      options.backend = Backend::multifrontal;
      const auto solver = make_solver(options);
      solver->set_last(last);
      REQUIRE(solver->analyze(A));
      REQUIRE(solver->factorize(A));
      Eigen::MatrixXd S(count, count);
      solver->schur_complement(S.data());
      // The inverse of the Schur complement is a block of the inverse.
      const Eigen::MatrixXd inverse = dense(A).llt().solve(Eigen::MatrixXd::Identity(A.size, A.size));
      const Eigen::MatrixXd product = S * inverse(last, last);
      CHECK((product - Eigen::MatrixXd::Identity(count, count)).norm() <= 1e-9);
      CHECK(S == S.transpose());
    }
}

TEST_CASE("last unknowns: patterns that change a little keep them last") {
  const SymmetricMatrix A = grid_2d(12);
  const std::vector<int> last = some_unknowns(A, 9);
  Options options;
  options.backend = Backend::multifrontal;
  const auto solver = make_solver(options);
  solver->set_last(last);
  REQUIRE(solver->analyze(A));
  REQUIRE(solver->update_pattern(A));
  REQUIRE(solver->factorize(A));
  Eigen::MatrixXd S(9, 9);
  solver->schur_complement(S.data());
  const Eigen::MatrixXd inverse = dense(A).llt().solve(Eigen::MatrixXd::Identity(A.size, A.size));
  CHECK((S * inverse(last, last) - Eigen::MatrixXd::Identity(9, 9)).norm() <= 1e-9);
}

TEST_CASE("last unknowns: misuse is named") {
  const SymmetricMatrix A = grid_2d(5);
  const auto solver = make_solver({});
  CHECK_THROWS_WITH_AS(solver->set_last({3, -1}), doctest::Contains("unknown -1"), Error);
  CHECK_THROWS_WITH_AS(solver->set_last({3, 4, 3}), doctest::Contains("unknown 3"), Error);
  solver->set_last({A.size});
  CHECK_THROWS_WITH_AS(solver->analyze(A), doctest::Contains("last of"), Error);
  double S[1];
  solver->set_last({0});
  REQUIRE(solver->analyze(A));
  CHECK_THROWS_WITH_AS(solver->schur_complement(S), doctest::Contains("factorize"), Error);
  Options options;
  options.backend = Backend::eigen_ldlt;
  const auto other = make_solver(options);
  other->set_last({0});
  REQUIRE(other->analyze(A));
  REQUIRE(other->factorize(A));
  CHECK_THROWS_WITH_AS(other->schur_complement(S), doctest::Contains("eigen_ldlt"), Error);
  // What has been analyzed was another order.
  other->set_last({1});
  CHECK_THROWS_AS(other->factorize(A), Error);
}
