#include "affine_fit.hpp"

#include <isostretch/assembly/deformation_gradient.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::parameterization {
namespace {

using Matrix2 = Eigen::Matrix<double, 2, 2, Eigen::DontAlign>;

template <class Visit>
void for_each_gradient(const mesh::ElementArrays& rest, const mesh::Points2& uv, const Visit& visit) {
  for (std::size_t t = 0; t < rest.weights.size(); ++t) {
    const auto gradient = assembly::deformation_gradient<2, double>(
        3, [&](int c, int i) { return uv(rest.nodes[3 * t + static_cast<std::size_t>(c)], i); },
        [&](int c, int j) { return rest.gradients[6 * t + static_cast<std::size_t>(2 * c + j)]; });
    Matrix2 F;
    F << gradient[0][0], gradient[0][1], gradient[1][0], gradient[1][1];
    visit(F, F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0), rest.weights[t]);
  }
}

// Square root of a symmetric positive definite matrix: (M + sqrt(det M)) / sqrt(tr M + 2 sqrt(det M)).
Matrix2 root(const Matrix2& M) {
  const double s = std::sqrt(std::max(M(0, 0) * M(1, 1) - M(0, 1) * M(1, 0), 0.0));
  Matrix2 R = M;
  R(0, 0) += s;
  R(1, 1) += s;
  return R / std::sqrt(M(0, 0) + M(1, 1) + 2 * s);
}

Matrix2 inverse(const Matrix2& M) {
  const double determinant = M(0, 0) * M(1, 1) - M(0, 1) * M(1, 0);
  Matrix2 I;
  I << M(1, 1), -M(0, 1), -M(1, 0), M(0, 0);
  return I / determinant;
}

}  // namespace

double stretch_energy(const mesh::ElementArrays& rest, const mesh::Points2& uv) {
  double sum = 0;
  for_each_gradient(rest, uv, [&](const Matrix2& F, double J, double weight) {
    sum += J > 0 ? weight * F.squaredNorm() * (1 + 1 / (J * J)) : HUGE_VAL;
  });
  return sum;
}

// With F -> A F and S = A^T A the energy is tr(S M) + tr(S^-1 N), M = sum w F F^T, N = sum w F^-T F^-1,
// smallest where S M S = N.
void fit_affinely(const mesh::ElementArrays& rest, mesh::Points2& uv) {
  Matrix2 M = Matrix2::Zero(), N = Matrix2::Zero();
  for_each_gradient(rest, uv, [&](const Matrix2& F, double, double weight) {
    const Matrix2 G = inverse(F);
    M += weight * F * F.transpose();
    N += weight * G.transpose() * G;
  });
  const Matrix2 r = root(M), q = inverse(r);
  const Matrix2 A = root(q * root(r * N * r) * q);
  if (!A.allFinite()) return;
  for (Eigen::Index i = 0; i < uv.rows(); ++i) uv.row(i) = (A * uv.row(i).transpose()).transpose();
}

}  // namespace isostretch::parameterization
