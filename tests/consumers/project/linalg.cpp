// Signed singular values of a reflection, and its closest rotation.
#include "expect.hpp"

#include <isostretch/linalg/decompositions.hpp>

#include <Eigen/LU>

int main() {
  Eigen::Matrix3d F;
  F << 1.0, 0.3, -0.2, 0.1, 2.0, 0.4, -0.5, 0.2, -0.7;
  const auto svd = isostretch::linalg::signed_svd<3>(F);
  EXPECT((svd.U * svd.sigma.asDiagonal() * svd.V.transpose() - F).norm() < 1e-14 * F.norm());
  EXPECT(F.determinant() < 0 && svd.sigma[2] < 0);
  EXPECT(std::abs(svd.U.determinant() - 1) < 1e-14 && std::abs(svd.V.determinant() - 1) < 1e-14);

  const auto polar = isostretch::linalg::polar<3>(F);
  EXPECT((polar.R - svd.U * svd.V.transpose()).norm() < 1e-13);
  EXPECT((polar.R * polar.S - F).norm() < 1e-14 * F.norm());
}
