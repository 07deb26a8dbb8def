#include <isostretch/core/error.hpp>
#include <isostretch/linalg/decompositions.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <random>
#include <vector>

#include "every_level.hpp"
#include "numerical.hpp"

using namespace isostretch;

namespace {

template <int Dim>
void check_eigen(const Eigen::Matrix<double, Dim, Dim>& A) {
  using Matrix = Eigen::Matrix<double, Dim, Dim>;
  const auto eigen = linalg::symmetric_eigen<Dim>(A);
  CAPTURE(A);
  CAPTURE(eigen.lambda.transpose());
  CHECK((eigen.Q.transpose() * eigen.Q - Matrix::Identity()).norm() < std::max(5e-15, 2e-15 * Dim));
  CHECK(eigen.Q.determinant() > 0);
  const Matrix rebuilt = eigen.Q * eigen.lambda.asDiagonal() * eigen.Q.transpose();
  CHECK((rebuilt - A).cwiseAbs().maxCoeff() <= 1e-14 * A.cwiseAbs().maxCoeff());
  Eigen::Matrix<double, Dim, 1> sorted = eigen.lambda;
  std::sort(sorted.data(), sorted.data() + Dim);
  CHECK((sorted - tests::numerical_eigensystem(A).values).norm() <= 1e-13 * A.norm());
}

template <int Dim>
void check_all() {
  using Matrix = Eigen::Matrix<double, Dim, Dim>;
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  check_eigen<Dim>(Matrix::Zero());
  check_eigen<Dim>(Matrix::Identity());
  check_eigen<Dim>(Matrix::Ones());
  check_eigen<Dim>(-Matrix::Ones());
  for (int trial = 0; trial < 300; ++trial) {
    const Matrix B = Matrix::NullaryExpr([&] { return normal(generator); });
    const Matrix A = B + B.transpose();
    check_eigen<Dim>(A);
    check_eigen<Dim>(A * 1e140);
    check_eigen<Dim>(A * 1e-140);
    check_eigen<Dim>(B.col(0) * B.col(0).transpose());
    check_eigen<Dim>(Matrix::Identity() + 1e-14 * A);
  }
}

}  // namespace

TEST_CASE("symmetric eigen-decomposition: orthogonal, rebuilds A, agrees with Eigen") {
  tests::at_every_level([] {
    check_all<2>();
    check_all<3>();
    check_all<4>();
    check_all<6>();
  });
}

TEST_CASE("symmetric eigen-decomposition: eigenvalues alone are the same bits") {
  tests::at_every_level([] {
    std::mt19937 generator(4);
    std::normal_distribution<double> normal;
    for (const int dim : {2, 3, 4, 6}) {
      constexpr std::size_t count = 37;
      const auto entries = static_cast<std::size_t>(dim * dim), rows = static_cast<std::size_t>(dim);
      std::vector<double> A(entries * count), Q(A.size()), with(rows * count), alone(with.size());
      for (double& entry : A) entry = normal(generator);
      linalg::symmetric_eigen(dim, {A.data(), with.data(), Q.data(), count, count});
      linalg::symmetric_eigen(dim, {A.data(), alone.data(), nullptr, count, count});
      CHECK(with == alone);
    }
  });
}

TEST_CASE("symmetric eigen-decomposition: sizes without a kernel are refused") {
  for (const int dim : {1, 5, 7})
    CHECK_THROWS_WITH_AS(linalg::symmetric_eigen(dim, {}), doctest::Contains("2, 3, 4 and 6 rows"), Error);
}

TEST_CASE("symmetric eigen-decomposition: a graded positive definite matrix keeps its small eigenvalue") {
  tests::at_every_level([] {
    // D M D with M = I + 0.5 off the diagonal and D = diag(1, 2^-20, 2^-40): det = det(M) * prod(D)^2.
    Eigen::Matrix3d A;
    const double d[3] = {1.0, 0x1p-20, 0x1p-40};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) A(i, j) = (i == j ? 1.0 : 0.5) * d[i] * d[j];
    const auto eigen = linalg::symmetric_eigen<3>(A);
    CHECK(eigen.lambda.minCoeff() > 0);
    CHECK(eigen.lambda.prod() == doctest::Approx(0.5 * 0x1p-120).epsilon(1e-14));
  });
}
