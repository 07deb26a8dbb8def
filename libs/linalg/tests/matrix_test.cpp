#include <isostretch/linalg/cholesky.hpp>
#include <isostretch/linalg/matrix.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <limits>
#include <random>

using namespace isostretch;
using linalg::Mat;

namespace {

template <int Dim>
using Matrix = Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>;

template <int Dim>
Matrix<Dim> eigen(const Mat<Dim>& A) {
  Matrix<Dim> result;
  linalg::to_rows(A, result.data());
  return result;
}

template <int Dim, class Body>
void for_random_matrices(const Body& body) {
  std::mt19937 generator(Dim);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 50; ++trial)
    body(Matrix<Dim>(Matrix<Dim>::NullaryExpr([&] { return normal(generator); })));
}

template <int Dim>
void check_operations() {
  for_random_matrices<Dim>([](const Matrix<Dim>& A) {
    const Matrix<Dim> B = 2 * A * A - A;
    const Mat<Dim> a = linalg::from_rows<Dim>(A.data()), b = linalg::from_rows<Dim>(B.data());
    CHECK(eigen(a) == A);
    CHECK(eigen(linalg::from_columns<Dim>(A.data())) == A.transpose());
    CHECK(eigen(transposed(a)) == A.transpose());
    CHECK((eigen(a * b) - A * B).norm() <= 1e-14 * A.norm() * B.norm());
    CHECK((eigen(symmetric_part(a)) - 0.5 * (A + A.transpose())).norm() <= 1e-15 * A.norm());
    CHECK(inner_product(a, b) == doctest::Approx(A.cwiseProduct(B).sum()));
    Mat<Dim> c = a;
    c += b;
    c *= 3.0;
    CHECK((eigen(c) - 3 * (A + B)).norm() <= 1e-14 * (A + B).norm());
  });
}

template <int Dim>
void check_determinant() {
  for_random_matrices<Dim>([](const Matrix<Dim>& A) {
    const Mat<Dim> a = linalg::from_rows<Dim>(A.data());
    const double scale = std::pow(A.norm(), Dim);
    CHECK(std::abs(determinant(a) - A.determinant()) <= 1e-14 * scale);
    // A cof(A)^T = det(A) I.
    const Matrix<Dim> product = A * eigen(cofactor(a)).transpose();
    CHECK((product - A.determinant() * Matrix<Dim>::Identity()).norm() <= 1e-14 * scale);
  });
}

template <int Dim>
void check_cholesky() {
  for_random_matrices<Dim>([](const Matrix<Dim>& B) {
    const Matrix<Dim> A = B * B.transpose() + 0.1 * Matrix<Dim>::Identity();
    Mat<Dim> L;
    REQUIRE(linalg::cholesky(linalg::from_rows<Dim>(A.data()), L));
    const Matrix<Dim> factor = eigen(L);
    CHECK(factor.isLowerTriangular(0));
    CHECK((factor * factor.transpose() - A).norm() <= 1e-14 * A.norm());
    CHECK((eigen(linalg::inverse_of_lower(L)) * factor - Matrix<Dim>::Identity()).norm() <= 1e-11);

    Eigen::Matrix<double, Dim, 1> z = B.col(0);
    const auto entry = [&](int i, int j) { return L[i][j]; };
    linalg::solve_lower(Dim, entry, [&](int i) -> double& { return z[i]; });
    linalg::solve_lower_transposed(Dim, entry, [&](int i) -> double& { return z[i]; });
    CHECK((A * z - B.col(0)).norm() <= 1e-13 * A.norm() * z.norm());

    Matrix<Dim> indefinite = A;
    indefinite(Dim - 1, Dim - 1) = -1;
    CHECK_FALSE(linalg::cholesky(linalg::from_rows<Dim>(indefinite.data()), L));
    Matrix<Dim> none = A;
    none(0, 0) = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(linalg::cholesky(linalg::from_rows<Dim>(none.data()), L));
  });
}

}  // namespace

TEST_CASE("small matrices: operations agree with those of Eigen") {
  check_operations<2>();
  check_operations<3>();
  check_operations<4>();
  check_operations<6>();
}

TEST_CASE("small matrices: determinants and cofactors") {
  check_determinant<2>();
  check_determinant<3>();
}

TEST_CASE("Cholesky: L L^T is A, solutions solve, and what is not positive definite is refused") {
  check_cholesky<2>();
  check_cholesky<3>();
  check_cholesky<4>();
  check_cholesky<6>();
}

TEST_CASE("Cholesky: the column without a positive pivot is named") {
  double A[9] = {4, 2, 0, 2, 1, 0, 0, 0, 1};  // rank two
  CHECK(linalg::cholesky(3, [&](int i, int j) -> double& { return A[3 * i + j]; }) == 1);
}
