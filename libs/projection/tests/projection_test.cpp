#include <isostretch/core/error.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/projection/eigensystem.hpp>
#include <isostretch/projection/projection.hpp>
#include <isostretch/testing/deformation_samples.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <random>
#include <vector>

#include "every_level.hpp"
#include "numerical.hpp"

using namespace isostretch;
using projection::Filter;
using testing::random_rotation;
using tests::numerical_eigensystem;

namespace {

template <int Dim>
using MatrixD = Eigen::Matrix<double, Dim, Dim>;
template <int Dim>
using Hessian = Eigen::Matrix<double, Dim * Dim, Dim * Dim>;

// Stretches of every kind that has broken a projection somewhere: near rest, repeated, opposite, zero,
// graded.
template <int Dim>
std::vector<MatrixD<Dim>> deformations(bool inverted_too) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<std::array<double, 3>> sigmas = {{1, 1, 1},      {2, 2, 2},     {0.5, 0.5, 0.5},
                                               {2, 1, 1},      {1, 1, 0.3},   {1 + 1e-9, 1, 1},
                                               {1e3, 1, 1e-3}, {5, 0.2, 0.1}, {1e-2, 1e-2, 1e-2}};
  if (inverted_too)
    for (const auto& s : std::vector<std::array<double, 3>>{
             {1, 1, -1}, {2, 1, -0.5}, {1, 0.5, -0.5 + 1e-7}, {3, 2, 0}, {1, 0, 0}, {0, 0, 0}, {4, 3, -2.9}})
      sigmas.push_back(s);
  for (int i = 0; i < 40; ++i) {
    std::array<double, 3> s;
    for (double& value : s) value = std::exp2(2 * uniform(generator));
    if (inverted_too && i % 2) s[2] = -s[2];
    sigmas.push_back(s);
  }
  std::vector<MatrixD<Dim>> result;
  for (const auto& s : sigmas) {
    MatrixD<Dim> S = MatrixD<Dim>::Zero();
    for (int i = 0; i < Dim; ++i) S(i, i) = s[static_cast<std::size_t>(i == Dim - 1 ? 2 : i)];
    result.push_back(random_rotation<Dim>(generator) * S * random_rotation<Dim>(generator).transpose());
  }
  return result;
}

Eigen::MatrixXd numerically_filtered(const Eigen::MatrixXd& H, Filter filter, double threshold) {
  const auto eigen = numerical_eigensystem(H);
  Eigen::VectorXd lambda = eigen.values;
  if (filter == Filter::abs) lambda = lambda.cwiseAbs();
  if (filter != Filter::none) lambda = lambda.cwiseMax(threshold);
  return eigen.vectors * lambda.asDiagonal() * eigen.vectors.transpose();
}

template <int Dim>
void check_filters(const energies::AnyEnergy& energy) {
  CAPTURE(energy.name());
  int checked = 0;
  for (const auto& F : deformations<Dim>(!energy.has_barrier())) {
    CAPTURE(F);
    const auto exact = projection::evaluate<Dim>(energy, F, {Filter::none});
    if (!std::isfinite(exact.psi)) continue;
    REQUIRE(exact.H.allFinite());
    // Genuine singularities (sigma_j + sigma_k = 0) give twists of 1e12 and more: the numerical reference
    // cannot resolve the rest beside them.
    const double norm = exact.H.norm();
    if (norm > 1e11) continue;
    ++checked;
    for (const Filter filter : {Filter::clamp, Filter::abs})
      for (const double threshold : {0.0, 1e-3}) {
        const auto filtered = projection::evaluate<Dim>(energy, F, {filter, threshold});
        const Hessian<Dim> expected = numerically_filtered(exact.H, filter, threshold);
        CHECK((filtered.H - expected).norm() <= 1e-13 * norm + 1e-14);
        const double smallest = numerical_eigensystem(filtered.H).values[0];
        CHECK(smallest >= threshold - 1e-14 * norm);
        if (!filtered.filtered) CHECK((filtered.H.array() == exact.H.array()).all());
      }
  }
  CHECK(checked > 20);
}

// Stress and exact Hessian against central differences of psi and of the stress.
template <int Dim>
void check_derivatives(const energies::AnyEnergy& energy) {
  CAPTURE(energy.name());
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  int checked = 0;
  for (int trial = 0; trial < 10; ++trial) {
    MatrixD<Dim> F = random_rotation<Dim>(generator);
    F += MatrixD<Dim>::NullaryExpr([&] { return uniform(generator); });
    if (energy.has_barrier() && F.determinant() < 0.1) continue;
    ++checked;
    const auto at = projection::evaluate<Dim>(energy, F, {Filter::none});
    for (int e = 0; e < Dim * Dim; ++e) {
      const double h = 1e-5;
      MatrixD<Dim> plus = F, minus = F;
      plus(e) += h;
      minus(e) -= h;
      const auto up = projection::evaluate<Dim>(energy, plus, {Filter::none});
      const auto down = projection::evaluate<Dim>(energy, minus, {Filter::none});
      const double scale = 1.0 + at.H.norm();
      CHECK(std::abs((up.psi - down.psi) / (2 * h) - at.P(e)) < 2e-8 * scale * scale);
      const MatrixD<Dim> dP = (up.P - down.P) / (2 * h);
      CHECK((Eigen::Map<const Eigen::VectorXd>(dP.data(), Dim * Dim) - at.H.col(e)).norm() <
            1e-7 * scale * scale);
    }
  }
  CHECK(checked > 5);
}

template <class Check>
void for_every_energy_and_level(const Check& check) {
  tests::at_every_level([&] {
    for (const auto& name : energies::energy_names()) check(energies::make_energy(name));
  });
}

}  // namespace

TEST_CASE("filters agree with numerical eigen-decomposition for every energy, dimension and level") {
  for_every_energy_and_level([](const energies::AnyEnergy& energy) {
    if (energy.supports(2)) check_filters<2>(energy);
    if (energy.supports(3)) check_filters<3>(energy);
  });
}

TEST_CASE("stress and Hessian agree with finite differences for every energy, dimension and level") {
  for_every_energy_and_level([](const energies::AnyEnergy& energy) {
    if (energy.supports(2)) check_derivatives<2>(energy);
    if (energy.supports(3)) check_derivatives<3>(energy);
  });
}

TEST_CASE("the eigensystem diagonalises the exact Hessian; singular energies are refused") {
  for (const auto& name : energies::energy_names()) {
    const auto energy = energies::make_energy(name);
    if (!energy.supports(3)) continue;
    CAPTURE(name);
    int checked = 0;
    for (const auto& F : deformations<3>(!energy.has_barrier())) {
      const auto H = projection::evaluate<3>(energy, F, {Filter::none}).H;
      if (!H.allFinite() || H.norm() > 1e11) continue;
      ++checked;
      const auto eigen = projection::eigensystem<3>(energy, F);
      CHECK((eigen.vectors.transpose() * eigen.vectors - Hessian<3>::Identity()).norm() < 1e-14);
      CHECK((eigen.vectors * eigen.values.asDiagonal() * eigen.vectors.transpose() - H).norm() <=
            1e-13 * H.norm() + 1e-14);
    }
    CHECK(checked > 20);
  }
  Eigen::Matrix2d mirrored;
  mirrored << 1, 0, 0, -1;
  CHECK_THROWS_WITH_AS(projection::eigensystem<2>(energies::make_energy("mips_2d"), mirrored),
                       doctest::Contains("not finite"), Error);
}

TEST_CASE("a Hessian that is positive semi-definite passes every filter bit for bit") {
  const auto energy = energies::make_energy("neo_hookean_log");
  const Eigen::Matrix3d F = 1.2 * Eigen::Matrix3d::Identity();
  const auto exact = projection::evaluate<3>(energy, F, {Filter::none});
  for (const Filter filter : {Filter::clamp, Filter::abs, Filter::bounded_abs}) {
    const auto filtered = projection::evaluate<3>(energy, F, {filter});
    CHECK_FALSE(filtered.filtered);
    CHECK((filtered.H.array() == exact.H.array()).all());
  }
}

// Where no eigenvalue is more negative than the largest of the rest, absolute values are not bounded.
TEST_CASE("bounded absolute values: clamping at weight 0, absolute values at 1 within the bound") {
  tests::at_every_level([] {
    for (const auto& name : energies::energy_names()) {
      const auto energy = energies::make_energy(name);
      if (!energy.supports(3)) continue;
      CAPTURE(name);
      int checked = 0;
      for (const auto& F : deformations<3>(!energy.has_barrier())) {
        CAPTURE(F);
        const auto exact = projection::evaluate<3>(energy, F, {Filter::none});
        if (!std::isfinite(exact.psi) || exact.H.norm() > 1e11) continue;
        ++checked;
        const double norm = exact.H.norm();
        const auto bounded = [&](double weight) {
          return projection::evaluate<3>(energy, F, {Filter::bounded_abs, 0.0, weight}).H;
        };
        const auto clamped = projection::evaluate<3>(energy, F, {Filter::clamp}).H;
        const auto absolute = projection::evaluate<3>(energy, F, {Filter::abs}).H;
        CHECK((bounded(0.0) - clamped).norm() <= 1e-13 * norm + 1e-14);
        // Between the two in the order of positive semi-definite matrices.
        const auto smallest = [](const Hessian<3>& H) { return numerical_eigensystem(H).values[0]; };
        for (const double weight : {0.3, 1.0}) {
          CHECK(smallest(bounded(weight) - clamped) >= -1e-13 * norm);
          CHECK(smallest(absolute - bounded(weight)) >= -1e-13 * norm);
        }
        const auto eigen = numerical_eigensystem(exact.H);
        const auto& lambda = eigen.values;
        // The largest eigenvalue of a shear that stiffens is a flip or a scaling mode; twists soften.
        if (lambda[0] < 0 && -lambda[0] < lambda[8] && name == "stable_neo_hookean")
          CHECK((bounded(1.0) - absolute).norm() <= 1e-13 * norm);
      }
      CHECK(checked > 20);
    }
  });
}

TEST_CASE("a twist without bounds does not make the body rigid: bounded absolute values stay finite") {
  const auto energy = energies::make_energy("arap");
  const Eigen::Matrix3d collapsed = Eigen::Matrix3d::Zero();
  const auto largest = [&](Filter filter) {
    const auto H = projection::evaluate<3>(energy, collapsed, {filter}).H;
    return numerical_eigensystem(H).values[8];
  };
  CHECK(largest(Filter::abs) > 1e10);
  CHECK(largest(Filter::bounded_abs) == doctest::Approx(2.0));
}

TEST_CASE("weight moves eigenvalues part of the way, 0 not at all") {
  const auto energy = energies::make_energy("arap");
  const Eigen::Matrix2d F = 0.4 * Eigen::Matrix2d::Identity();  // twist 2 - 4/0.8 = -3
  const auto smallest = [&](double weight) {
    const auto H = projection::evaluate<2>(energy, F, {Filter::clamp, 0.0, weight}).H;
    return numerical_eigensystem(H).values[0];
  };
  CHECK(smallest(0.0) == doctest::Approx(-3.0));
  CHECK(smallest(0.5) == doctest::Approx(-1.5));
  CHECK(std::abs(smallest(1.0)) < 1e-15);
}

TEST_CASE("sigma_j + sigma_k = 0: finite, and clamping does what the limit of the twist would") {
  for (const char* name : {"arap", "corotational", "fixed_corotational"}) {
    const auto energy = energies::make_energy(name);
    Eigen::Matrix2d F;
    F << 1, 0, 0, -1;
    const auto exact = projection::evaluate<2>(energy, F, {Filter::none});
    CHECK(exact.H.allFinite());
    CHECK(exact.P.allFinite());
    const auto clamped = projection::evaluate<2>(energy, F, {Filter::clamp});
    CHECK(clamped.H.norm() < 100.0);  // the twist tends to -infinity here, hence to 0 when clamped
    for (const auto& zero : {Eigen::Matrix3d(Eigen::Matrix3d::Zero())}) {
      const auto at = projection::evaluate<3>(energy, zero, {Filter::clamp});
      CHECK(at.H.allFinite());
      CHECK(at.H.norm() < 100.0);
    }
  }
}

TEST_CASE("outside the domain psi is infinite and derivatives are NaN, never plausible numbers") {
  const auto energy = energies::make_energy("symmetric_dirichlet");
  Eigen::Matrix2d F;
  F << 1, 0, 0, -1;
  const auto at = projection::evaluate<2>(energy, F);
  CHECK(std::isinf(at.psi));
  CHECK(std::isnan(at.P(0, 0)));
  CHECK(std::isnan(at.H(0, 0)));
}

TEST_CASE("batches of any size equal single points bit for bit") {
  std::mt19937 generator(31);
  std::normal_distribution<double> normal;
  const auto energy = energies::make_energy("stable_neo_hookean");
  for (const std::size_t count : {1u, 7u, 32u, 33u, 100u}) {
    std::vector<double> F(9 * count), psi(count), P(9 * count), H(45 * count);
    for (double& value : F) value = normal(generator);
    projection::evaluate(energy, 3, {}, {F.data(), psi.data(), P.data(), H.data(), count, count});
    for (std::size_t i = 0; i < count; ++i) {
      Eigen::Matrix3d M;
      for (int e = 0; e < 9; ++e) M(e) = F[static_cast<std::size_t>(e) * count + i];
      const auto single = projection::evaluate<3>(energy, M);
      CHECK(single.psi == psi[i]);
      for (int e = 0; e < 9; ++e) CHECK(single.P(e) == P[static_cast<std::size_t>(e) * count + i]);
      CHECK(single.H(0, 0) == H[i]);
      CHECK(single.H(8, 8) == H[44 * count + i]);
    }
  }
}

TEST_CASE(
    "element gradients and Hessians equal B^T P, B^T H B; blocked and strided batches agree bit for bit") {
  std::mt19937 generator(37);
  std::normal_distribution<double> normal;
  const std::size_t count = 150, block = 64, padded = 192;
  const auto strided = [&](std::size_t e, std::size_t i) { return e * count + i; };
  const auto blocked = [&](std::size_t entries, std::size_t e, std::size_t i) {
    return (i / block * entries + e) * block + i % block;
  };
  for (const char* name : {"arap", "stable_neo_hookean"}) {
    const auto energy = energies::make_energy(name);
    std::vector<double> F(9 * count), B(9 * count), w(count), P(9 * count), H(45 * count), G(12 * count),
        K(78 * count);
    std::vector<double> Fb(9 * padded), Bb(9 * padded), wb(padded), Gb(12 * padded), Kb(78 * padded);
    for (std::size_t i = 0; i < count; ++i) {
      wb[i] = w[i] = 0.5 + normal(generator) * normal(generator);
      for (std::size_t e = 0; e < 9; ++e) {
        Fb[blocked(9, e, i)] = F[strided(e, i)] = normal(generator);
        Bb[blocked(9, e, i)] = B[strided(e, i)] = normal(generator);
      }
    }
    projection::HessianBatch batch{F.data(), nullptr, P.data(), H.data(), count, count};
    batch.gradients = B.data(), batch.weights = w.data(), batch.G = G.data(), batch.K = K.data();
    projection::HessianBatch in_blocks{Fb.data()};
    in_blocks.count = count, in_blocks.block = block;
    in_blocks.gradients = Bb.data(), in_blocks.weights = wb.data(), in_blocks.G = Gb.data(),
    in_blocks.K = Kb.data();
    CHECK(projection::evaluate(energy, 3, {}, batch) == projection::evaluate(energy, 3, {}, in_blocks));
    for (std::size_t i = 0; i < count; ++i) {
      Eigen::Matrix<double, 9, 12> D = Eigen::Matrix<double, 9, 12>::Zero();
      Eigen::Matrix<double, 9, 9> H9;
      Eigen::Matrix<double, 9, 1> P9;
      for (int c = 0, e = 0; c < 9; ++c) {
        P9[c] = P[strided(static_cast<std::size_t>(c), i)];
        for (int d = c; d < 9; ++d) H9(c, d) = H9(d, c) = H[strided(static_cast<std::size_t>(e++), i)];
      }
      for (int a = 1; a < 4; ++a)
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 3; ++c) {
            const double g = B[strided(static_cast<std::size_t>(3 * (a - 1) + c), i)];
            D(r + 3 * c, 3 * a + r) = g;
            D(r + 3 * c, r) -= g;
          }
      const Eigen::Matrix<double, 12, 12> expected = w[i] * D.transpose() * H9 * D;
      const Eigen::Matrix<double, 12, 1> force = w[i] * D.transpose() * P9;
      double worst = 0;
      for (std::size_t c = 0, e = 0; c < 12; ++c) {
        CHECK(std::abs(G[strided(c, i)] - force[static_cast<Eigen::Index>(c)]) <= 1e-13 * (1 + force.norm()));
        CHECK(G[strided(c, i)] == Gb[blocked(12, c, i)]);
        for (std::size_t d = c; d < 12; ++d, ++e) {
          worst = std::max(worst, std::abs(K[strided(e, i)] - expected(static_cast<Eigen::Index>(c),
                                                                       static_cast<Eigen::Index>(d))));
          CHECK(K[strided(e, i)] == Kb[blocked(78, e, i)]);
        }
      }
      CHECK(worst <= 1e-13 * (1 + expected.norm()));
    }
  }
}

TEST_CASE("wrong dimensions and unknown filters are refused by name") {
  const auto energy = energies::make_energy("mips_2d");
  CHECK_THROWS_WITH_AS(projection::evaluate<3>(energy, Eigen::Matrix3d::Identity()),
                       doctest::Contains("mips_2d"), Error);
  CHECK_THROWS_WITH_AS(projection::filter_from_name("flip"), doctest::Contains("none, clamp, abs"), Error);
}
