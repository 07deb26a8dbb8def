#include <isostretch/linalg/symmetric_eigen_ql.hpp>

#include <doctest/doctest.h>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace isostretch;

namespace {

constexpr int capacity = 30;
using Matrix = Eigen::MatrixXd;
using Decomposition = linalg::SymmetricEigenQl<capacity>;

struct Errors {
  double pairs = 0, orthogonality = 0;
};

// |A Q - Q D| over |A|, and |Q^T Q - I|.
Errors errors_of(const Matrix& A) {
  const int n = static_cast<int>(A.rows());
  const Decomposition eigen(A.data(), n);
  REQUIRE(eigen.converged());
  Matrix Q(n, n), D = Matrix::Zero(n, n);
  for (int k = 0; k < n; ++k) {
    D(k, k) = eigen.value(k);
    for (int i = 0; i < n; ++i) Q(i, k) = eigen.vector(k)[i];
  }
  const double size = A.cwiseAbs().maxCoeff();
  if (size == 0) return {D.norm(), (Q.transpose() * Q - Matrix::Identity(n, n)).norm()};
  const Matrix unit = A / size;
  return {(unit * Q - Q * (D / size)).norm(), (Q.transpose() * Q - Matrix::Identity(n, n)).norm()};
}

void check(const Matrix& A) {
  const Errors errors = errors_of(A);
  const double bound = 1e-15 * static_cast<double>(A.rows() * A.rows()) + 1e-14;
  CHECK(errors.pairs < bound);
  CHECK(errors.orthogonality < bound);
}

Matrix random_symmetric(std::mt19937& generator, int n) {
  std::normal_distribution<double> normal;
  const Matrix M = Matrix::NullaryExpr(n, n, [&] { return normal(generator); });
  return M + M.transpose();
}

}  // namespace

TEST_SUITE("symmetric eigen-decomposition by QL steps") {
  TEST_CASE("pairs and orthogonality, 1 to 30 rows, full and of low rank, and of any size") {
    std::mt19937 generator(5);
    for (int n = 1; n <= capacity; ++n)
      for (int sample = 0; sample < 40; ++sample) {
        CAPTURE(n);
        const Matrix A = random_symmetric(generator, n);
        check(A);
        check(std::ldexp(1.0, 900) * A);
        check(std::ldexp(1.0, -900) * A);
        const Matrix thin = A.leftCols(std::max(1, n / 3));
        check(thin * thin.transpose());
      }
  }

  TEST_CASE("matrices that are special") {
    check(Matrix::Zero(5, 5));
    check(Matrix::Identity(12, 12));
    check(Matrix::Ones(9, 9));
    check(Matrix(Eigen::VectorXd::LinSpaced(6, -3, 4).asDiagonal()));
    Matrix graded(4, 4);  // from 1 to 1e-12 along the diagonal, either way
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) graded(i, j) = std::pow(10.0, -2.0 * (i + j)) * (i == j ? 2 : 1);
    check(graded);
    check(graded.reverse().eval());
    for (const double tiny : {1e-140, 1e-150, 1e-155, 1e-160, 1e-165, 1e-300, 5e-324}) {
      Matrix nearly = Eigen::Vector3d(2, 1, 3).asDiagonal();
      nearly(0, 2) = nearly(2, 0) = tiny;
      check(nearly);
    }
    check(1e-310 * Matrix::Identity(3, 3));
    const double smallest = 1e-310;
    CHECK(Decomposition(&smallest, 1).value(0) == smallest);
    Matrix swap = Matrix::Zero(2, 2);
    swap(0, 1) = swap(1, 0) = 1;
    check(swap);
    check(1e-170 * swap);
    Matrix wilkinson = Matrix::Zero(21, 21);  // pairs of eigenvalues that agree to many digits
    for (int i = 0; i < 21; ++i) {
      wilkinson(i, i) = std::abs(i - 10);
      if (i > 0) wilkinson(i, i - 1) = wilkinson(i - 1, i) = 1;
    }
    check(wilkinson);
  }

  TEST_CASE("what is not finite does not converge") {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
      for (int at = 0; at < 9; ++at) {
        Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
        A.data()[at] = bad;
        CHECK(!Decomposition(A.data(), 3).converged());
      }
  }
}
