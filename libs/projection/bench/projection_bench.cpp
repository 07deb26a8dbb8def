// Cost per tetrahedron of SVD + energy + stress + clamped 9x9 + element gradient + clamped 12x12, for every
// 3D energy, beside numerically projecting a 12x12 matrix with Eigen. F: one third each near the identity,
// rotated stretches 2^u, and the same with one axis negated (not for energies with a barrier). One thread;
// arrays far larger than the caches.
#include <isostretch/energies/registry.hpp>
#include <isostretch/projection/projection.hpp>

#include <benchmark/benchmark.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace isostretch;

constexpr int count = 200000;

std::vector<Eigen::Matrix3d> mixture(bool inverted_too) {
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Eigen::Matrix3d> result;
  for (int i = 0; i < count; ++i) {
    const Eigen::Matrix3d A = Eigen::Matrix3d::NullaryExpr([&] { return normal(generator); });
    if (i % 3 == 0) {
      Eigen::Matrix3d F = Eigen::Matrix3d::Identity() + 0.1 * A;
      if (!inverted_too && F.determinant() < 0.05) F = Eigen::Matrix3d::Identity();
      result.push_back(F);
      continue;
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d s = Eigen::Vector3d::NullaryExpr([&] { return std::exp2(uniform(generator)); });
    Eigen::Matrix3d F = svd.matrixU() * s.asDiagonal() * svd.matrixV().transpose();
    if (F.determinant() < 0) F.col(0) *= -1;
    if (i % 3 == 2 && inverted_too) F.col(0) *= -1;
    result.push_back(F);
  }
  return result;
}

// Rest gradients of nodes 1, 2, 3 (row by row) and volume of a random tetrahedron.
struct Rest {
  double gradients[9];
  double volume;
};

std::vector<Rest> rest_shapes() {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  std::vector<Rest> result(count);
  for (Rest& rest : result) {
    Eigen::Matrix3d Dm = Eigen::Matrix3d::Identity();
    Dm += Eigen::Matrix3d::NullaryExpr([&] { return uniform(generator); });
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rest.gradients) = Dm.inverse();
    rest.volume = std::abs(Dm.determinant()) / 6;
  }
  return result;
}

constexpr std::size_t block = 64;
constexpr std::size_t padded = (count + block - 1) / block * block;

// In blocks: see HessianBatch.
template <class Item>
std::vector<double> blocked(const std::vector<Item>& items, int entries, double (*entry)(const Item&, int)) {
  std::vector<double> data(static_cast<std::size_t>(entries) * padded);
  for (std::size_t i = 0; i < items.size(); ++i)
    for (int e = 0; e < entries; ++e)
      data[(i / block * static_cast<std::size_t>(entries) + static_cast<std::size_t>(e)) * block +
           i % block] = entry(items[i], e);
  return data;
}

void report(benchmark::State& state) {
  state.counters["ns_each"] =
      benchmark::Counter(static_cast<double>(count) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// in_cache: results go to a buffer of `step` points that is used again and again, as an assembly does;
// otherwise every point keeps its results, nearly 1.2 kB each, and the memory is what is measured.
void element_blocks(benchmark::State& state, const std::string& name, bool in_cache) {
  const auto energy = energies::make_energy(name);
  const auto F = blocked<Eigen::Matrix3d>(mixture(!energy.has_barrier()), 9,
                                          [](const Eigen::Matrix3d& M, int e) { return M(e); });
  const auto rest = rest_shapes();
  const auto gradients = blocked<Rest>(rest, 9, [](const Rest& r, int e) { return r.gradients[e]; });
  const auto weights = blocked<Rest>(rest, 1, [](const Rest& r, int) { return r.volume; });
  const std::size_t step = in_cache ? 4 * block : count, kept = in_cache ? step : padded;
  std::vector<double> psi(kept), P(9 * kept), H(45 * kept), G(12 * kept), K(78 * kept);
  for (auto _ : state) {
    std::size_t filtered = 0;
    for (std::size_t begin = 0; begin < count; begin += step) {
      projection::HessianBatch batch{F.data() + 9 * begin, psi.data(), P.data(), H.data()};
      batch.count = std::min<std::size_t>(step, count - begin);
      batch.block = block;
      batch.gradients = gradients.data() + 9 * begin;
      batch.weights = weights.data() + begin;
      batch.G = G.data();
      batch.K = K.data();
      filtered += projection::evaluate(energy, 3, {}, batch);
      benchmark::ClobberMemory();
    }
    state.counters["filtered"] = static_cast<double>(filtered) / count;
  }
  report(state);
}

void numerical_12x12(benchmark::State& state) {
  using Matrix12 = Eigen::Matrix<double, 12, 12>;
  const auto energy = energies::make_energy("arap");
  const auto F = mixture(true);
  const auto rest = rest_shapes();
  std::vector<Matrix12> blocks;
  for (int e = 0; e < 20000; ++e) {
    const auto at =
        projection::evaluate<3>(energy, F[static_cast<std::size_t>(e)], {projection::Filter::none});
    Eigen::Matrix<double, 9, 12> D = Eigen::Matrix<double, 9, 12>::Zero();
    for (int a = 1; a < 4; ++a)
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
          const double g = rest[static_cast<std::size_t>(e)].gradients[3 * (a - 1) + c];
          D(r + 3 * c, 3 * a + r) = g;
          D(r + 3 * c, r) -= g;
        }
    blocks.push_back(D.transpose() * at.H * D);
  }
  for (auto _ : state) {
    for (int i = 0; i < count; ++i) {
      const Eigen::SelfAdjointEigenSolver<Matrix12> eigen(
          blocks[static_cast<std::size_t>(i) % blocks.size()]);
      Matrix12 projected = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
                           eigen.eigenvectors().transpose();
      benchmark::DoNotOptimize(projected.data());
    }
  }
  report(state);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::RegisterBenchmark("numerical_projection_12x12", numerical_12x12)->Unit(benchmark::kMillisecond);
  for (const auto& name : energies::energy_names()) {
    if (!energies::make_energy(name).supports(3)) continue;
    for (const bool in_cache : {true, false})
      benchmark::RegisterBenchmark(((in_cache ? "blocks_in_cache/" : "blocks_stored/") + name).c_str(),
                                   element_blocks, name, in_cache)
          ->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
