// Cost per matrix of the batched decompositions beside Eigen's, on the mixture of F described in
// docs/benchmarks.
#include <isostretch/linalg/decompositions.hpp>

#include <benchmark/benchmark.h>

#include <Eigen/Dense>

#include <random>
#include <vector>

namespace {

constexpr std::size_t count = 200000;

// One third each: near the identity; random rotations around stretches 2^u, u in [-1, 1]; the same with one
// negated.
std::vector<double> mixture() {
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> F(9 * count);
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Matrix3d M;
    const Eigen::Matrix3d A = Eigen::Matrix3d::NullaryExpr([&] { return normal(generator); });
    if (i % 3 == 0) {
      M = Eigen::Matrix3d::Identity() + 0.1 * A;
    } else {
      const Eigen::JacobiSVD<Eigen::Matrix3d> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
      Eigen::Vector3d s = Eigen::Vector3d::NullaryExpr([&] { return std::exp2(uniform(generator)); });
      if (i % 3 == 2) s[2] = -s[2];
      M = svd.matrixU() * s.asDiagonal() * svd.matrixV().transpose();
    }
    for (int e = 0; e < 9; ++e) F[static_cast<std::size_t>(e) * count + i] = M(e);
  }
  return F;
}

void batch_svd(benchmark::State& state) {
  const std::vector<double> F = mixture();
  std::vector<double> U(9 * count), sigma(3 * count), V(9 * count);
  for (auto _ : state) {
    isostretch::linalg::signed_svd(3, {F.data(), U.data(), sigma.data(), V.data(), count, count});
    benchmark::ClobberMemory();
  }
  state.counters["ns_each"] =
      benchmark::Counter(static_cast<double>(count) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void eigen_jacobi_svd(benchmark::State& state) {
  const std::vector<double> F = mixture();
  for (auto _ : state) {
    for (std::size_t i = 0; i < count; ++i) {
      Eigen::Matrix3d M;
      for (int e = 0; e < 9; ++e) M(e) = F[static_cast<std::size_t>(e) * count + i];
      Eigen::JacobiSVD<Eigen::Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
      benchmark::DoNotOptimize(svd.matrixU().data());
    }
  }
  state.counters["ns_each"] =
      benchmark::Counter(static_cast<double>(count) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace

BENCHMARK(batch_svd)->Unit(benchmark::kMillisecond);
BENCHMARK(eigen_jacobi_svd)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
