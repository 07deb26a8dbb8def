// Unknowns that are eliminated last: refactorizations of theirs alone, and their Schur complement.
#include "every_level.hpp"
#include "matrices.hpp"
#include "threads.hpp"

#include <isostretch/cholesky/factor.hpp>
#include <isostretch/core/error.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <random>
#include <vector>

using namespace isostretch;
using namespace isostretch::cholesky;
using namespace isostretch::cholesky::test;

namespace {

struct Case {
  Matrix A;
  int last;
};

// A few unknowns of large and of small trees, coupled and not, all of them, a single one, and none.
std::vector<Case> cases() {
  return {{grid(21, 19, 2), 40},
          {grid(21, 19, 2), 300},
          {grid(9, 7, 1), 63},
          {grid(9, 7, 1), 1},
          {random_matrix(60, 0, 1), 9},
          {grid(5, 5, 1), 0},
          {random_matrix(400, 1, 2), 250}};
}

// Entries both of whose unknowns are among the last ones change, and the matrix stays positive definite.
void change(Matrix& A, const std::vector<int>& last, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(0.5, 1.5);
  std::vector<bool> is_last(static_cast<std::size_t>(A.size), false);
  for (const int unknown : last) is_last[unknown] = true;
  for (int j = 0; j < A.size; ++j)
    for (int k = A.start[j]; k < A.start[j + 1]; ++k)
      if (is_last[j] && is_last[A.row[k]])
        A.value[k] = A.row[k] == j ? 2 * A.value[k] : A.value[k] * uniform(generator);
}

Eigen::VectorXd solved(Factor& factor, const Eigen::VectorXd& b) {
  Eigen::VectorXd x(b.size());
  factor.solve(b.data(), x.data());
  return x;
}

}  // namespace

TEST_CASE("a refactorization of the last unknowns gives the bits of a factorization, whatever the threads") {
  for (const Case& one : cases())
    for (const int threads : {1, 2, 3, 5}) {
      set_threads(threads);
      Matrix A = one.A;
      const Analysis analysis(A.pattern(), shuffled(A.size, 4), {}, one.last);
      Factor kept(analysis);
      REQUIRE(kept.refactorize(A.value.data()));  // nothing is there yet
      const Eigen::VectorXd b = Eigen::VectorXd::Random(A.size);
      for (const unsigned seed : {1U, 2U, 3U}) {
        change(A, analysis.last(), seed);
        REQUIRE(kept.refactorize(A.value.data()));
        Factor anew(analysis);
        REQUIRE(anew.factorize(A.value.data()));
        CHECK((solved(kept, b).array() == solved(anew, b).array()).all());
      }
    }
  set_threads(0);
}

TEST_CASE("a refactorization that fails names the pivot, and the next one succeeds") {
  Matrix A = grid(20, 15, 1);
  const Analysis analysis(A.pattern(), shuffled(A.size, 3), {}, 30);
  Factor factor(analysis);
  REQUIRE(factor.factorize(A.value.data()));
  const int unknown = analysis.last()[7];
  const double diagonal = A.value[A.start[unknown]];
  const Eigen::VectorXd b = Eigen::VectorXd::Random(A.size), x = solved(factor, b);
  A.value[A.start[unknown]] = -1;
  const FactorizeResult failed = factor.refactorize(A.value.data());
  CHECK(failed.status == FactorizeStatus::not_positive_definite);
  CHECK(failed.unknown == unknown);
  CHECK_FALSE(factor.is_ready());
  A.value[A.start[unknown]] = diagonal;
  REQUIRE(factor.refactorize(A.value.data()));
  CHECK((solved(factor, b).array() == x.array()).all());
}

TEST_CASE("the Schur complement of the last unknowns is that of the dense matrix, in the order given") {
  tests::at_every_level([] {
    for (const Case& one : cases()) {
      const Analysis analysis(one.A.pattern(), shuffled(one.A.size, 6), {}, one.last);
      Factor factor(analysis);
      REQUIRE(factor.factorize(one.A.value.data()));
      Eigen::MatrixXd S(one.last, one.last);
      factor.schur_complement(S.data());

      const std::vector<int> order = shuffled(one.A.size, 6);
      const Eigen::MatrixXd A = one.A.dense()(order, order);
      const int others = one.A.size - one.last;
      Eigen::MatrixXd expected = A.bottomRightCorner(one.last, one.last);
      if (others > 0 && one.last > 0)
        expected -= A.bottomLeftCorner(one.last, others) *
                    A.topLeftCorner(others, others).llt().solve(A.topRightCorner(others, one.last));
      CHECK((S - expected).norm() <= 1e-14 * A.norm());
    }
  });
}

TEST_CASE("more unknowns than there are, or fewer than none, cannot be the last") {
  const Matrix A = grid(3, 3, 1);
  CHECK_THROWS_WITH_AS(Analysis(A.pattern(), {}, {}, 10), doctest::Contains("10 unknowns"), Error);
  CHECK_THROWS_AS(Analysis(A.pattern(), {}, {}, -1), Error);
  const Analysis analysis(A.pattern(), {}, {}, 2);
  CHECK(analysis.last() == std::vector<int>{7, 8});
  double S[4];
  CHECK_THROWS_WITH_AS(Factor(analysis).schur_complement(S), doctest::Contains("without a factor"), Error);
}
