#include "../src/distortion/scaling_matrix.hpp"

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <limits>
#include <random>
#include <type_traits>

using namespace isostretch;

TEST_SUITE("nearest semi-definite matrix") {
  TEST_CASE("what is not finite is clamped to no numbers") {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
      for (int at = 0; at < 9; ++at) {
        Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
        A.data()[at] = bad;
        CHECK(baselines::nearest_semidefinite<3>(A).array().isNaN().all());
      }
  }

  TEST_CASE("it is that of another decomposition") {
    std::mt19937 generator(6);
    std::normal_distribution<double> normal;
    const auto check_size = [&](auto n) {
      constexpr int size = decltype(n)::value;
      using Square = Eigen::Matrix<double, size, size>;
      for (int sample = 0; sample < 100; ++sample) {
        const Square M = Square::NullaryExpr([&] { return normal(generator); }), A = M + M.transpose();
        // Of run-time size: one reference to compile for all six.
        const Square best = baselines::clamped(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A));
        CHECK((baselines::nearest_semidefinite<size>(A) - best).norm() < 1e-13 * A.norm());
      }
    };
    check_size(std::integral_constant<int, 2>{});
    check_size(std::integral_constant<int, 3>{});
    check_size(std::integral_constant<int, 4>{});
    check_size(std::integral_constant<int, 6>{});
    check_size(std::integral_constant<int, 9>{});
    check_size(std::integral_constant<int, 12>{});
  }
}
