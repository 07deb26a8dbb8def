// Factors of small matrices against dense ones, and what does not depend on threads.
#include "every_level.hpp"
#include "matrices.hpp"
#include "threads.hpp"

#include <isostretch/cholesky/factor.hpp>
#include <isostretch/core/error.hpp>

#include <doctest/doctest.h>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::cholesky;
using namespace isostretch::cholesky::test;

namespace {

double backward_error(const Matrix& A, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  const Eigen::MatrixXd dense = A.dense();
  return (dense * x - b).norm() / (dense.norm() * x.norm() + b.norm());
}

void check_solves(const Matrix& A, std::span<const int> order = {}) {
  const Analysis analysis(A.pattern(), order);
  Factor factor(analysis);
  REQUIRE(factor.factorize(A.value.data()));
  const Eigen::MatrixXd B = Eigen::MatrixXd::Random(A.size, 11);
  for (const int columns : {1, 2, 11}) {
    Eigen::MatrixXd X(A.size, columns);
    factor.solve(B.data(), X.data(), columns);
    for (int c = 0; c < columns; ++c) CHECK(backward_error(A, X.col(c), B.col(c)) < 1e-15);
  }
}

}  // namespace

TEST_CASE("structure: rows, counts and places fit the factor of the dense matrix") {
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    const Matrix A = random_matrix(60, 0.03 * seed, seed);
    for (const bool merge : {false, true}) {
      Amalgamation options;
      if (!merge) options = {{0, 0, 0}, {0, 0, 0, 0}};
      const Analysis analysis(A.pattern(), shuffled(A.size, seed), options);
      const Structure& s = analysis.structure();
      Eigen::PermutationMatrix<Eigen::Dynamic> P(A.size);
      for (int p = 0; p < A.size; ++p) P.indices()[s.order[p]] = p;
      // Positive values everywhere: nothing cancels.
      const Eigen::MatrixXd pattern = (A.dense().array() != 0).cast<double>();
      const Eigen::MatrixXd permuted =
          P * Eigen::MatrixXd(-pattern + 2 * A.size * Eigen::MatrixXd::Identity(A.size, A.size)) *
          P.transpose();
      const Eigen::MatrixXd L = permuted.llt().matrixL();
      double entries = 0;
      for (int j = 0; j < A.size; ++j)
        for (int i = j; i < A.size; ++i) entries += L(i, j) != 0;
      CHECK(analysis.factor_nonzeros() == entries);
      int columns = 0;
      for (int k = 0; k < s.count(); ++k) {
        const Supernode& node = s.supernode[k];
        CHECK(node.first == columns);
        columns += node.columns;
        CHECK(s.supernode[k + 1].row - node.row == node.update_rows());
        for (int j = node.first; j < columns; ++j)
          for (int i = columns; i < A.size; ++i)
            if (L(i, j) != 0)
              CHECK(std::binary_search(s.row.begin() + node.row,
                                       s.row.begin() + node.row + node.update_rows(), i));
      }
      CHECK(columns == A.size);
      CHECK(s.entry.size() == A.row.size());
    }
  }
}

TEST_CASE("solutions of random matrices, grids, and what is hard on a tree") {
  tests::at_every_level([] {
    for (const int size : {1, 2, 3, 7, 8, 9, 17, 64, 150})
      for (const double density : {0.0, 0.02, 0.2, 1.0}) {
        const Matrix A = random_matrix(size, density, static_cast<unsigned>(size));
        check_solves(A);
        check_solves(A, shuffled(size, 5));
      }
    for (const int block : {1, 2, 3}) check_solves(grid(13, 9, block), shuffled(13 * 9 * block, 7));
    // A chain, an arrow and its reverse.
    Eigen::MatrixXd A = Eigen::MatrixXd::Identity(400, 400) * 3;
    for (int i = 0; i + 1 < 400; ++i) A(i, i + 1) = A(i + 1, i) = -1;
    check_solves(lower(A));
    A = Eigen::MatrixXd::Identity(200, 200) * 300;
    A.row(0).setOnes();
    A.col(0).setOnes();
    A(0, 0) = 300;
    check_solves(lower(A));
    check_solves(lower(A.reverse()));
  });
}

TEST_CASE("a large front is factorised in blocks") {
  tests::at_every_level([] { check_solves(random_matrix(700, 1.0, 3)); });
}

TEST_CASE("the same bits for any number of threads") {
  // Many small fronts; and a few large ones, which threads share.
  for (const Matrix& A : {grid(34, 31, 2), random_matrix(900, 0.005, 4)}) {
    const Analysis analysis(A.pattern(), shuffled(A.size, 9));
    const Eigen::VectorXd b = Eigen::VectorXd::Random(A.size);
    set_threads(0);
    std::vector<Eigen::VectorXd> solutions;
    for (const int threads : {1, 2, 3, 5, 2, 5}) {
      set_threads(threads);
      Factor factor(analysis);
      REQUIRE(factor.factorize(A.value.data()));
      Eigen::VectorXd& x = solutions.emplace_back(A.size);
      factor.solve(b.data(), x.data());
      CHECK((x.array() == solutions.front().array()).all());
    }
  }
  set_threads(0);
}

TEST_CASE("many more threads than cores, and than branches of the tree") {
  for (const Matrix& A : {repeated(grid(4, 4, 1), 130), grid(34, 31, 1), grid(3, 3, 1)}) {
    const Analysis analysis(A.pattern());
    const Eigen::VectorXd b = Eigen::VectorXd::Random(A.size);
    for (const int threads : {64, 150, 200}) {
      set_threads(threads);
      Factor factor(analysis);
      REQUIRE(factor.factorize(A.value.data()));
      Eigen::VectorXd x(A.size);
      set_threads(2);
      factor.solve(b.data(), x.data());
      CHECK(backward_error(A, x, b) < 1e-15);
    }
  }
  set_threads(0);
}

TEST_CASE("a pivot that fails is named, whatever the threads, and the next matrix is factorised") {
  Matrix A = grid(20, 15, 1);
  const Analysis analysis(A.pattern(), shuffled(A.size, 3));
  Factor factor(analysis);
  const auto diagonal = [&](int unknown) -> double& { return A.value[A.start[unknown]]; };
  set_threads(0);
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    const int first = analysis.structure().order[100], second = analysis.structure().order[250];
    const double kept[] = {diagonal(first), diagonal(second)};
    diagonal(first) = diagonal(second) = bad;
    for (const int threads : {1, 2, 4}) {
      set_threads(threads);
      const FactorizeResult result = factor.factorize(A.value.data());
      CHECK(result.status ==
            (std::isfinite(bad) ? FactorizeStatus::not_positive_definite : FactorizeStatus::not_finite));
      CHECK(result.unknown == first);
      CHECK_FALSE(factor.is_ready());
    }
    diagonal(first) = kept[0];
    diagonal(second) = kept[1];
    CHECK(factor.factorize(A.value.data()));
  }
  set_threads(0);
}

TEST_CASE("scale decides nothing: from the smallest numbers to the largest") {
  for (const double scale : {1e-290, 1e-100, 1.0, 1e100, 1e290}) {
    Matrix A = grid(9, 9, 2);
    for (double& value : A.value) value *= scale;
    const Analysis analysis(A.pattern());
    Factor factor(analysis);
    CHECK(factor.factorize(A.value.data()));
  }
}

TEST_CASE("a solve without a factor is refused, and no right-hand side is no work") {
  const Matrix A = grid(3, 3, 1);
  const Analysis analysis(A.pattern());
  Factor factor(analysis);
  std::vector<double> x(9, 1.0);
  CHECK_THROWS_WITH_AS(factor.solve(x.data(), x.data()), doctest::Contains("without a factor"), Error);
  REQUIRE(factor.factorize(A.value.data()));
  factor.solve(x.data(), x.data(), 0);
  CHECK(x == std::vector<double>(9, 1.0));
}

TEST_CASE("the limit of memory is respected before memory is taken") {
  const Matrix A = grid(20, 20, 1);
  const Analysis analysis(A.pattern());
  Factor factor(analysis);
  factor.limit_memory(factor.bytes(1) - 1);
  CHECK(factor.factorize(A.value.data()).status == FactorizeStatus::out_of_memory);
  factor.limit_memory(factor.bytes(64));
  CHECK(factor.factorize(A.value.data()));
}

TEST_CASE("patterns and orders that are none are refused") {
  const std::vector<int> start{0, 2, 3}, upper{0, 1, 0}, none{1, 1, 1};
  CHECK_THROWS_WITH_AS(Analysis({2, start.data(), upper.data()}), doctest::Contains("column 1 has row 0"),
                       Error);
  CHECK_THROWS_WITH_AS(Analysis({2, start.data(), none.data()}), doctest::Contains("no diagonal"), Error);
  const Matrix A = grid(2, 1, 1);
  const std::vector<int> twice{0, 0};
  CHECK_THROWS_WITH_AS(Analysis(A.pattern(), twice), doctest::Contains("unknown 0"), Error);
  CHECK(Analysis().size() == 0);
}
