#include <isostretch/core/error.hpp>
#include <isostretch/linalg/decompositions.hpp>
#include <isostretch/testing/deformation_samples.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <random>
#include <vector>

#include "every_level.hpp"
#include "numerical.hpp"

using namespace isostretch;
using testing::random_rotation;
using tests::at_every_level;

namespace {

template <int Dim>
using Matrix = Eigen::Matrix<double, Dim, Dim>;

template <int Dim>
Matrix<Dim> random_matrix(std::mt19937& generator) {
  std::normal_distribution<double> normal;
  return Matrix<Dim>::NullaryExpr([&] { return normal(generator); });
}

// Everything the header promises, to a few roundings.
template <int Dim>
void check_svd(const Matrix<Dim>& F) {
  const auto svd = linalg::signed_svd<Dim>(F);
  CAPTURE(F);
  CAPTURE(svd.sigma.transpose());
  const Matrix<Dim> I = Matrix<Dim>::Identity();
  CHECK((svd.U.transpose() * svd.U - I).cwiseAbs().maxCoeff() < 4e-15);
  CHECK((svd.V.transpose() * svd.V - I).cwiseAbs().maxCoeff() < 4e-15);
  CHECK(svd.U.determinant() > 0);
  CHECK(svd.V.determinant() > 0);
  const double scale = F.cwiseAbs().maxCoeff();
  const Matrix<Dim> rebuilt = svd.U * svd.sigma.asDiagonal() * svd.V.transpose();
  CHECK((rebuilt - F).cwiseAbs().maxCoeff() <= 1e-14 * scale);
  for (int i = 0; i + 1 < Dim; ++i) {
    CHECK(svd.sigma[i] >= std::abs(svd.sigma[i + 1]));
    CHECK(svd.sigma[i] >= 0);
  }
}

template <int Dim>
void check_random() {
  std::mt19937 generator(7);
  for (int trial = 0; trial < 300; ++trial) {
    const Matrix<Dim> F = random_matrix<Dim>(generator);
    check_svd<Dim>(F);
    const auto svd = linalg::signed_svd<Dim>(F);
    const Eigen::VectorXd reference = tests::numerical_singular_values(F);
    for (int i = 0; i < Dim; ++i)
      CHECK(std::abs(svd.sigma[i]) == doctest::Approx(reference[i]).epsilon(1e-13));
    CHECK(std::signbit(svd.sigma[Dim - 1]) == (F.determinant() < 0));
  }
}

template <int Dim>
void check_degenerate() {
  std::mt19937 generator(11);
  const Matrix<Dim> zero = Matrix<Dim>::Zero(), I = Matrix<Dim>::Identity();
  check_svd<Dim>(zero);
  CHECK(linalg::signed_svd<Dim>(zero).sigma.isZero(0));
  check_svd<Dim>(I);
  CHECK((linalg::signed_svd<Dim>(I).sigma.array() == 1.0).all());
  Matrix<Dim> reflection = I;
  reflection(0, 0) = -1;
  check_svd<Dim>(reflection);
  CHECK(linalg::signed_svd<Dim>(reflection).sigma[Dim - 1] == -1.0);
  check_svd<Dim>(-I);
  for (int trial = 0; trial < 100; ++trial) {
    const Matrix<Dim> A = random_matrix<Dim>(generator);
    const Matrix<Dim> R = random_rotation<Dim>(generator), Q = random_rotation<Dim>(generator);
    check_svd<Dim>(R);
    check_svd<Dim>(A.col(0) * A.row(1));                          // rank one
    check_svd<Dim>(A.col(0) * Eigen::RowVectorXd::Unit(Dim, 1));  // one column
    check_svd<Dim>(Eigen::VectorXd::Unit(Dim, 0) * A.row(0));     // one row
    Matrix<Dim> S = Matrix<Dim>::Zero();                          // repeated and cancelling sigma
    S.diagonal().setConstant(2.0);
    S(Dim - 1, Dim - 1) = trial % 2 ? 2.0 : -2.0;
    check_svd<Dim>(R * S * Q.transpose());
    S(0, 0) = 2.0 + 1e-13;
    check_svd<Dim>(R * S * Q.transpose());
    Matrix<Dim> singular = A;
    singular.col(Dim - 1).setZero();
    check_svd<Dim>(singular);
    CHECK(linalg::signed_svd<Dim>(singular).sigma[Dim - 1] == 0.0);
  }
}

template <int Dim>
void check_range() {
  std::mt19937 generator(13);
  std::uniform_real_distribution<double> exponent(-150, 150);
  for (int trial = 0; trial < 500; ++trial) {
    Matrix<Dim> F = random_matrix<Dim>(generator);
    for (int i = 0; i < Dim * Dim; ++i) F(i) *= std::pow(10.0, exponent(generator));
    for (int i = 0; i < Dim * Dim; ++i)
      if (std::abs(F(i)) > 1e150) F(i) = std::copysign(1e150, F(i));
    check_svd<Dim>(F);
    check_svd<Dim>(random_matrix<Dim>(generator) * 1e150);
    check_svd<Dim>(random_matrix<Dim>(generator) * 1e-150);
  }
}

}  // namespace

TEST_CASE("signed SVD: factors are rotations, rebuild F and agree with Eigen's JacobiSVD") {
  at_every_level([] {
    check_random<2>();
    check_random<3>();
  });
}

TEST_CASE("signed SVD: zero, rank one, rotations, reflections and repeated sigma") {
  at_every_level([] {
    check_degenerate<2>();
    check_degenerate<3>();
  });
}

TEST_CASE("bug: an exchange of columns without a rotation must not end the sweeps") {
  // F = I + 1e-5 e_r e_c^T once came back as the identity: the exchange moved the oblique pair out of sight.
  at_every_level([] {
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        for (const double size : {1e-5, 1e-8, 1e-12, 0.5}) {
          Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
          F(row, column) += size;
          check_svd<3>(F);
          check_svd<2>(F.topLeftCorner<2, 2>());
        }
  });
}

TEST_CASE("signed SVD: entries from 1e-150 to 1e150 in one matrix") {
  at_every_level([] {
    check_range<2>();
    check_range<3>();
  });
}

TEST_CASE("signed SVD: small sigma of column-graded matrices to high relative accuracy") {
  // F = A D with a well-conditioned A: every sigma is determined by the entries to about their relative
  // accuracy. The reference is the product of the sigmas, |det A| * prod D, which extended precision gives to
  // full accuracy.
  at_every_level([] {
    std::mt19937 generator(17);
    for (int trial = 0; trial < 200; ++trial) {
      const Eigen::Matrix3d A = random_rotation<3>(generator) + 0.2 * random_matrix<3>(generator);
      const double d1 = 0x1p-30, d2 = 0x1p-60;
      Eigen::Matrix3d F = A;
      F.col(trial % 3) *= d1;
      F.col((trial + 1) % 3) *= d2;
      const auto svd = linalg::signed_svd<3>(F);
      using Long = Eigen::Matrix<long double, 3, 3>;
      const Long L = A.cast<long double>();
      const long double det = L.row(0).dot(L.row(1).cross(L.row(2))) * d1 * d2;
      const double product = svd.sigma.prod();
      CHECK(std::abs(product - static_cast<double>(det)) <= 1e-14 * std::abs(static_cast<double>(det)));
    }
  });
}

TEST_CASE("signed SVD 2D: small sigma of nearly parallel columns to high relative accuracy") {
  at_every_level([] {
    Eigen::Matrix2d F;
    F << 1.0, 1.0, 1e-10, 2e-10;
    const auto svd = linalg::signed_svd<2>(F);
    const double det = 1e-10;  // 2e-10 - 1e-10 exactly
    CHECK(svd.sigma[1] == doctest::Approx(det / svd.sigma[0]).epsilon(4e-16));
  });
}

TEST_CASE("signed SVD: a matrix gives the same bits alone, in a batch and beside any neighbour") {
  at_every_level([] {
    std::mt19937 generator(19);
    const std::size_t count = 37;
    std::vector<double> F(9 * count), U(9 * count), sigma(3 * count), V(9 * count);
    std::vector<Eigen::Matrix3d> matrices(count);
    for (std::size_t i = 0; i < count; ++i) {
      matrices[i] = i % 5 == 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : random_matrix<3>(generator);
      for (int e = 0; e < 9; ++e) F[e * count + i] = matrices[i](e);
    }
    linalg::signed_svd(3, {F.data(), U.data(), sigma.data(), V.data(), count, count});
    for (std::size_t i = 0; i < count; ++i) {
      const auto single = linalg::signed_svd<3>(matrices[i]);
      for (int e = 0; e < 9; ++e) {
        CHECK(single.U(e) == U[e * count + i]);
        CHECK(single.V(e) == V[e * count + i]);
      }
      for (int e = 0; e < 3; ++e) CHECK(single.sigma(e) == sigma[e * count + i]);
    }
  });
}

TEST_CASE("polar: R is a rotation, S symmetric, F = R S") {
  at_every_level([] {
    std::mt19937 generator(23);
    for (int trial = 0; trial < 200; ++trial) {
      const Eigen::Matrix3d F = random_matrix<3>(generator);
      const auto polar = linalg::polar<3>(F);
      CHECK((polar.R * polar.S - F).norm() < 1e-14 * F.norm());
      CHECK((polar.S - polar.S.transpose()).norm() == 0.0);
      CHECK(polar.R.determinant() == doctest::Approx(1.0).epsilon(1e-14));
      const Eigen::Matrix2d G = random_matrix<2>(generator);
      const auto planar = linalg::polar<2>(G);
      CHECK((planar.R * planar.S - G).norm() < 1e-14 * G.norm());
      CHECK(planar.R.determinant() == doctest::Approx(1.0).epsilon(1e-14));
    }
  });
}

TEST_CASE("decompositions: dimensions and strides that make no sense are refused") {
  double F[16] = {};
  CHECK_THROWS_WITH_AS(linalg::signed_svd(4, {F, nullptr, nullptr, nullptr, 1, 1}),
                       doctest::Contains("dim 4"), Error);
  CHECK_THROWS_WITH_AS(linalg::signed_svd(2, {F, nullptr, nullptr, nullptr, 4, 2}),
                       doctest::Contains("stride"), Error);
  CHECK_THROWS_AS(linalg::polar(3, {nullptr, nullptr, nullptr, 1, 1}), Error);
}
