// The invariants of a stretch, and the rotation gradient against a difference quotient.
#include "expect.hpp"

#include <isostretch/invariants/eigensystem.hpp>
#include <isostretch/linalg/decompositions.hpp>

#include <Eigen/LU>

int main() {
  Eigen::Matrix2d F, step;
  F << 1.2, 0.4, -0.3, 0.9;
  step << 0.5, -0.2, 0.7, 0.1;
  const auto I = isostretch::invariants::invariants<2>(F);
  EXPECT(std::abs(I.I2 - F.squaredNorm()) < 1e-14);
  EXPECT(std::abs(I.I3 - F.determinant()) < 1e-14);

  const double h = 1e-6;
  const auto rotation = [](const Eigen::Matrix2d& M) { return isostretch::linalg::polar<2>(M).R; };
  const Eigen::Matrix2d difference = (rotation(F + h * step) - rotation(F - h * step)) / (2 * h);
  const Eigen::Vector4d analytic =
      isostretch::invariants::rotation_gradient<2>(F) * isostretch::invariants::vec<2>(step);
  EXPECT((analytic - isostretch::invariants::vec<2>(difference)).norm() < 1e-9);
}
