// A compressed point of ARAP: indefinite as it is, positive semi-definite after the filter.
#include "expect.hpp"

#include <isostretch/energies/registry.hpp>
#include <isostretch/projection/projection.hpp>

#include <Eigen/Eigenvalues>

int main() {
  const Eigen::Matrix3d F = 0.3 * Eigen::Matrix3d::Identity();
  const auto energy = isostretch::energies::make_energy("arap");
  const auto smallest = [](const auto& point) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>>(point.H).eigenvalues().minCoeff();
  };
  const auto exact = isostretch::projection::evaluate<3>(energy, F, {isostretch::projection::Filter::none});
  const auto clamped = isostretch::projection::evaluate<3>(energy, F);
  EXPECT(smallest(exact) < -0.1 && !exact.filtered);
  EXPECT(smallest(clamped) > -1e-12 && clamped.filtered);
  EXPECT((exact.P - clamped.P).norm() == 0);
}
