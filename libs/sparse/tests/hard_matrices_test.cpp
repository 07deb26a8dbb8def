// Factorizations of matrices that are hard on one: backward errors, honest definiteness, known solutions.
#include "every_solver.hpp"
#include "matrices.hpp"

#include <isostretch/sparse/solver.hpp>

#include <doctest/doctest.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace isostretch::sparse;
using namespace isostretch::sparse::test;

namespace {

// Calls body(solver, back end) for every factorization in every order there is.
template <class Body>
void for_each_factorization(const Body& body) {
  for_each_solver([&](const Options& options) {
    const auto factorizations = {Backend::multifrontal, Backend::cholmod_supernodal,
                                 Backend::cholmod_simplicial, Backend::eigen_ldlt};
    if (std::find(factorizations.begin(), factorizations.end(), options.backend) == factorizations.end())
      return;
    const auto solver = make_solver(options);
    body(*solver, options.backend);
  });
}

SymmetricMatrix tridiagonal(int size, double shift = 0) {
  Triplets triplets;
  for (int i = 0; i < size; ++i) {
    triplets.emplace_back(i, i, 2 + shift);
    if (i + 1 == size) continue;
    triplets.emplace_back(i, i + 1, -1);
    triplets.emplace_back(i + 1, i, -1);
  }
  return from_triplets(size, triplets);
}

SymmetricMatrix scaled(SymmetricMatrix A, const Eigen::VectorXd& d) {
  for (int j = 0; j < A.size; ++j)
    for (int k = A.column_start[j]; k < A.column_start[j + 1]; ++k) A.value[k] *= d[j] * d[A.row[k]];
  return A;
}

// Row `hub` is full.
SymmetricMatrix arrow(int size, int hub) {
  Triplets triplets;
  for (int i = 0; i < size; ++i) {
    triplets.emplace_back(i, i, i == hub ? size : 1.5);
    if (i == hub) continue;
    triplets.emplace_back(i, hub, 1);
    triplets.emplace_back(hub, i, 1);
  }
  return from_triplets(size, triplets);
}

// Chains of 1, 2, 3 ... unknowns that know nothing of each other.
SymmetricMatrix disconnected(int chains) {
  Triplets triplets;
  int size = 0;
  for (int length = 1; length <= chains; ++length)
    for (int i = 0; i < length; ++i, ++size) {
      triplets.emplace_back(size, size, 2);
      if (i == 0) continue;
      triplets.emplace_back(size, size - 1, -1);
      triplets.emplace_back(size - 1, size, -1);
    }
  return from_triplets(size, triplets);
}

SymmetricMatrix diagonal(int size) {
  Triplets triplets;
  for (int i = 0; i < size; ++i) triplets.emplace_back(i, i, std::pow(10.0, 12 - i % 25));
  return from_triplets(size, triplets);
}

std::vector<std::pair<std::string, SymmetricMatrix>> hard_matrices() {
  const SymmetricMatrix grid = grid_2d(16), body = grid_3d(5);
  std::mt19937 random(5);
  const auto logarithmic = [&](int size, double decades) {
    std::uniform_real_distribution<double> exponent(-decades / 2, 0);
    Eigen::VectorXd d(size);
    for (double& value : d) value = std::pow(10, exponent(random));
    return d;
  };
  Eigen::VectorXd descending(grid.size);
  for (int i = 0; i < grid.size; ++i) descending[i] = std::pow(10, -8.0 * i / grid.size);
  return {{"graded over 16 decades", scaled(grid, descending)},
          {"scaled at random over 16 decades", scaled(grid, logarithmic(grid.size, 16))},
          {"a body, scaled at random over 16 decades", scaled(body, logarithmic(body.size, 16))},
          {"nearly singular in the plane", grid_2d(16, 1e-12)},
          {"nearly singular in space", grid_3d(5, 1e-12)},
          {"a full first row", arrow(300, 0)},
          {"a full row in the middle", arrow(301, 150)},
          {"a full last row", arrow(300, 299)},
          {"disconnected", disconnected(30)},
          {"one unknown", diagonal(1)},
          {"a diagonal", diagonal(200)},
          {"at random", random_spd(400, 3, 7)}};
}

double backward_error(const SymmetricMatrix& A, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(A.size);
  for (int j = 0; j < A.size; ++j)
    for (int k = A.column_start[j]; k < A.column_start[j + 1]; ++k) {
      sums[A.row[k]] += std::abs(A.value[k]);
      if (A.row[k] != j) sums[j] += std::abs(A.value[k]);
    }
  return (A.multiply(x) - b).lpNorm<Eigen::Infinity>() /
         (sums.maxCoeff() * x.lpNorm<Eigen::Infinity>() + b.lpNorm<Eigen::Infinity>());
}

}  // namespace

TEST_CASE(
    "hard matrices: backward errors are those of a stable factorization, ours no larger than CHOLMOD's") {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  int compared = 0;
  for (const auto& matrix : hard_matrices()) {
    const auto& A = matrix.second;
    CAPTURE(matrix.first);
    Eigen::VectorXd b(A.size);
    for (double& value : b) value = normal(random);
    std::map<Backend, double> worst;
    for_each_factorization([&](Solver& solver, Backend backend) {
      REQUIRE(solver.analyze(A));
      const FactorResult factor = solver.factorize(A);
      CAPTURE(factor.message);
      REQUIRE(factor);
      Eigen::VectorXd x;
      REQUIRE(solver.solve(b, x));
      const double error = backward_error(A, x, b);
      CHECK(error <= 1e-14);
      worst[backend] = std::max(worst[backend], error);
    });
    if (!is_available(Backend::cholmod_supernodal)) continue;
    CHECK(worst[Backend::multifrontal] <= 4 * worst[Backend::cholmod_supernodal] + 1e-16);
    ++compared;
  }
  CHECK(compared == (is_available(Backend::cholmod_supernodal) ? 12 : 0));
}

TEST_CASE("hard matrices: indefinite by one eigenvalue, however close to zero it is") {
  for (const int size : {5, 40, 300}) {
    CAPTURE(size);
    const double smallest = 2 - 2 * std::cos(std::numbers::pi / (size + 1));
    for (const double part : {1e-3, 1e-6, 1e-9}) {
      CAPTURE(part);
      for_each_factorization([&](Solver& solver, Backend) {
        const SymmetricMatrix definite = tridiagonal(size, -(1 - part) * smallest);
        const SymmetricMatrix indefinite = tridiagonal(size, -(1 + part) * smallest);
        REQUIRE(solver.analyze(definite));
        CHECK(solver.factorize(definite));
        const FactorResult result = solver.factorize(indefinite);
        CHECK(result.status == FactorStatus::not_positive_definite);
        CHECK(solver.factorize(definite));
      });
    }
  }
}

TEST_CASE("hard matrices: products of sparse factors of integers have exact solutions of integers") {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> entry(-2, 2), place(0, 39), pivot(1, 3);
  for (int trial = 0; trial < 20; ++trial) {
    const int n = 40;
    Eigen::MatrixXd L = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd expected(n);
    for (int i = 0; i < n; ++i) {
      L(i, i) = pivot(random);
      expected[i] = entry(random);
      for (int k = 0; k < 2; ++k)
        if (const int j = place(random); j < i) L(i, j) = entry(random);
    }
    const Eigen::MatrixXd dense = L * L.transpose();
    const SymmetricMatrix A = lower_triangle(Eigen::SparseMatrix<double>(dense.sparseView()));
    const Eigen::VectorXd b = dense * expected;
    const double condition = dense.norm() * dense.inverse().norm();
    CAPTURE(condition);
    for_each_factorization([&](Solver& solver, Backend) {
      REQUIRE(solver.analyze(A));
      REQUIRE(solver.factorize(A));
      Eigen::VectorXd x;
      REQUIRE(solver.solve(b, x));
      CHECK((x - expected).norm() <= 1e-14 * condition * expected.norm());
    });
  }
}
