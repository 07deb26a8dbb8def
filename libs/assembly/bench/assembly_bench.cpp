// Cost per tetrahedron of SVD + energy + gradient + filtered Hessian, for every 3D energy, beside numerically
// projecting a 12x12 matrix with Eigen. F: one third each near the identity, rotated stretches 2^u, and the
// same with the smallest negated (for energies with a barrier: not negated). Disjoint elements, so that each
// F is free. One thread.
#include <isostretch/assembly/energy_assembler.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/projection/projection.hpp>

#include <benchmark/benchmark.h>
#include <omp.h>

#include <Eigen/Dense>

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

struct Tets {
  assembly::Elements elements;
  Eigen::VectorXd x;
};

// Random tetrahedra, each with nodes of its own, deformed by the given F.
Tets make_tets(const std::vector<Eigen::Matrix3d>& F) {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  Tets t;
  t.elements.dim = 3;
  t.elements.nodes_per_element = 4;
  t.elements.points_per_element = 1;
  t.elements.node_count = 4 * count;
  t.x.resize(12 * count);
  for (int e = 0; e < count; ++e) {
    Eigen::Matrix3d Dm = Eigen::Matrix3d::Identity();
    Dm += Eigen::Matrix3d::NullaryExpr([&] { return uniform(generator); });
    const Eigen::Matrix3d gradients = Dm.inverse();  // row a: gradient of node a + 1
    const Eigen::RowVector3d first = -gradients.colwise().sum();
    for (int a = 0; a < 4; ++a) {
      t.elements.nodes.push_back(4 * e + a);
      const Eigen::RowVector3d g = a == 0 ? first : Eigen::RowVector3d(gradients.row(a - 1));
      for (int d = 0; d < 3; ++d) t.elements.gradients.push_back(g[d]);
      t.x.segment<3>(12 * e + 3 * a) = a == 0
                                           ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                                           : Eigen::Vector3d(F[static_cast<std::size_t>(e)] * Dm.col(a - 1));
    }
    t.elements.weights.push_back(std::abs(Dm.determinant()) / 6);
  }
  return t;
}

void report(benchmark::State& state) {
  state.counters["ns_each"] =
      benchmark::Counter(static_cast<double>(count) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void element_blocks(benchmark::State& state, const std::string& name) {
  omp_set_num_threads(1);
  const auto energy = energies::make_energy(name);
  Tets t = make_tets(mixture(!energy.has_barrier()));
  assembly::EnergyAssembler assembler(t.elements, energy);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(t.x.size());
  for (auto _ : state) {
    const auto at = assembler.differentiate(t.x.data(), {}, gradient.data(), true);
    if (!(at.value < 1e300)) state.SkipWithError("energy is not finite");
    state.counters["filtered"] = static_cast<double>(at.points_filtered) / count;
  }
  report(state);
}

void point_hessians(benchmark::State& state, const std::string& name) {
  const auto energy = energies::make_energy(name);
  const auto F = mixture(!energy.has_barrier());
  std::vector<double> soa(9 * F.size()), psi(F.size()), P(9 * F.size()), H(45 * F.size());
  for (std::size_t i = 0; i < F.size(); ++i)
    for (int e = 0; e < 9; ++e) soa[static_cast<std::size_t>(e) * F.size() + i] = F[i](e);
  for (auto _ : state) {
    projection::evaluate(energy, 3, {}, {soa.data(), psi.data(), P.data(), H.data(), F.size(), F.size()});
    benchmark::ClobberMemory();
  }
  report(state);
}

void numerical_12x12(benchmark::State& state) {
  using Matrix12 = Eigen::Matrix<double, 12, 12>;
  const auto energy = energies::make_energy("arap");
  const auto F = mixture(true);
  const Tets t = make_tets(F);
  std::vector<Matrix12> blocks;
  for (int e = 0; e < 20000; ++e) {
    const auto at =
        projection::evaluate<3>(energy, F[static_cast<std::size_t>(e)], {projection::Filter::none});
    Eigen::Matrix<double, 9, 12> D = Eigen::Matrix<double, 9, 12>::Zero();
    for (int a = 0; a < 4; ++a)
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
          D(r + 3 * c, 3 * a + r) = t.elements.gradients[static_cast<std::size_t>(12 * e + 3 * a + c)];
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
    benchmark::RegisterBenchmark(("element_12x12/" + name).c_str(), element_blocks, name)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("point_9x9/" + name).c_str(), point_hessians, name)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
