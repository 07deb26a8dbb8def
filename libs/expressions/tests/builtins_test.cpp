#include "typed_builtins.hpp"

#include <isostretch/energies/registry.hpp>
#include <isostretch/expressions/expression.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/newton/minimize.hpp>
#include <isostretch/projection/projection.hpp>
#include <isostretch/testing/deformation_samples.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace isostretch;
using energies::AnyEnergy;

namespace {

// Stretches of 0.6 to 1.7, and every fifth sample with two that are equal, or nearly.
template <int Dim>
std::vector<Eigen::Matrix<double, Dim, Dim>> moderate(int count) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> factor(0.6, 1.7);
  std::vector<Eigen::Matrix<double, Dim, Dim>> all;
  for (int i = 0; i < count; ++i) {
    Eigen::Matrix<double, Dim, 1> sigma;
    for (int e = 0; e < Dim; ++e) sigma[e] = factor(generator);
    if (i % 5 == 0) sigma[1] = sigma[0];
    if (i % 5 == 1) sigma[1] = sigma[0] * (1 + 1e-9);
    all.push_back(testing::with_stretch<Dim>(sigma, generator));
  }
  return all;
}

template <int Dim>
void check_same(const AnyEnergy& typed, const AnyEnergy& built) {
  if (!built.supports(Dim)) return;
  REQUIRE(typed.supports(Dim));
  for (const auto& F : moderate<Dim>(100)) {
    const auto a = projection::evaluate<Dim>(typed, F), b = projection::evaluate<Dim>(built, F);
    const auto exact_a = projection::evaluate<Dim>(typed, F, {projection::Filter::none}),
               exact_b = projection::evaluate<Dim>(built, F, {projection::Filter::none});
    // Stress and psi may vanish; what they are made of is as large as the Hessian.
    const double size = exact_b.H.norm();
    CHECK(std::abs(a.psi - b.psi) <= 1e-12 * std::max(size, std::abs(b.psi)));
    CHECK((a.P - b.P).norm() <= 1e-12 * size);
    CHECK((exact_a.H - exact_b.H).norm() <= 1e-12 * size);
    CHECK((a.H - b.H).norm() <= 1e-12 * size);
  }
}

// Every iterate of a few steps from a sheared and stretched bar, held at its ends.
std::vector<Vector> iterates(const AnyEnergy& energy) {
  const mesh::TetMesh bar = mesh::tet_bar(4, 2, 2, 2, 1, 1);
  newton::Objective objective(3, static_cast<int>(bar.vertices.rows()));
  objective.add<newton::EnergyTerm>(assembly::elements_from(mesh::elements(bar)), energy);
  Vector x(3 * bar.vertices.rows());
  for (Eigen::Index i = 0; i < bar.vertices.rows(); ++i) {
    const double along = bar.vertices(i, 0);
    x.segment<3>(3 * i) = bar.vertices.row(i).transpose() + Eigen::Vector3d(0.3 * along, 0.2 * along, 0);
    if (along == 0 || along == 2) objective.pin(static_cast<int>(i));
  }
  std::vector<Vector> all;
  newton::Options options;
  options.max_iterations = 8;
  newton::minimize(objective, x, options, [&](const newton::Iteration&, const Vector& at) {
    all.push_back(at);
    return newton::CallbackAction::proceed;
  });
  return all;
}

}  // namespace

TEST_SUITE("typed built-in energies") {
  TEST_CASE("every one of them is here") {
    std::set<std::string> names;
    for (const auto& typed : tests::typed_builtins()) names.insert(typed.name);
    for (const std::string& name : energies::energy_names()) {
      CAPTURE(name);
      CHECK(names.count(name) == 1);
    }
  }

  TEST_CASE("psi, stress, Hessian and projected Hessian are the same, and so is the domain") {
    for (const auto& typed : tests::typed_builtins()) {
      CAPTURE(typed.name);
      const AnyEnergy parsed = expressions::parse_energy(typed.text, typed.parameters),
                      built = energies::make_energy(typed.name, typed.parameters);
      check_same<2>(parsed, built);
      check_same<3>(parsed, built);
      CHECK(parsed.has_barrier() == built.has_barrier());
    }
  }

  TEST_CASE("Newton takes the same path") {
    int checked = 0;
    for (const auto& typed : tests::typed_builtins()) {
      const AnyEnergy built = energies::make_energy(typed.name, typed.parameters);
      if (!built.supports(3) || typed.name == "log_barrier") continue;  // that one alone has no minimum
      ++checked;
      CAPTURE(typed.name);
      const auto a = iterates(expressions::parse_energy(typed.text, typed.parameters)), b = iterates(built);
      REQUIRE(a.size() > 1);
      REQUIRE(a.size() == b.size());
      for (std::size_t i = 0; i < a.size(); ++i) CHECK((a[i] - b[i]).norm() <= 1e-8 * b[i].norm());
    }
    CHECK(checked > 10);
  }
}

namespace {

// The largest error of psi near rest, in units of what nobody can avoid: rounding, and a change of every
// stretch by half a unit in its last place. The built-in energy is the reference.
template <int Dim>
double psi_error_near_rest(const AnyEnergy& typed, const AnyEnergy& built, double strain) {
  const auto psi_of = [](const AnyEnergy& energy, const invariants::PrincipalStretches<Dim, double>& s) {
    constexpr int points = 8;
    double sigma[Dim * points], psi[points];
    for (int e = 0; e < Dim; ++e) std::fill_n(sigma + e * points, points, s[e]);
    energies::StretchChunk chunk{};
    chunk.count = chunk.stride = points;
    chunk.sigma = sigma;
    chunk.psi = psi;
    energy.evaluate_psi(Dim, chunk);
    return psi[0];
  };
  invariants::PrincipalStretches<Dim, double> s;
  for (int e = 0; e < Dim; ++e) s.sigma[e] = 1 + strain * (1.3 - 0.9 * e);
  const double exact = psi_of(built, s);
  double allowed = std::abs(exact) * 0x1p-52;
  for (int e = 0; e < Dim; ++e) {
    auto moved = s;
    moved.sigma[e] *= 1 + 0x1p-52;  // a whole unit: half of one is lost
    allowed += 0.5 * std::abs(psi_of(built, moved) - exact);
  }
  return std::abs(psi_of(typed, s) - exact) / allowed;
}

}  // namespace

TEST_SUITE("typed built-in energies") {
  TEST_CASE("psi of typed energies keeps its digits near rest") {
    int checked = 0;
    for (const auto& typed : tests::typed_builtins()) {
      const AnyEnergy built = energies::make_energy(typed.name, typed.parameters);
      const AnyEnergy own = expressions::parse_energy(typed.text, typed.parameters);
      for (const double strain : {5e-2, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
        CAPTURE(typed.name);
        CAPTURE(strain);
        if (built.supports(2)) CHECK(psi_error_near_rest<2>(own, built, strain) <= 30);
        if (built.supports(3)) CHECK(psi_error_near_rest<3>(own, built, strain) <= 30);
        ++checked;
      }
    }
    CHECK(checked == 7 * static_cast<int>(tests::typed_builtins().size()));
  }

  TEST_CASE(
      "near rest and far from it psi is the same beside derivatives and by itself, in mixed chunks, too") {
    const AnyEnergy energy = expressions::parse_energy("mu*(I2*J^(-2/d) - d) + (J - 1)^2", {{"mu", 2}});
    constexpr int points = 16;
    double sigma[3 * points], psi[points], alone[points], rest[12 * points];
    for (int i = 0; i < points; ++i)
      for (int e = 0; e < 3; ++e)
        sigma[e * points + i] = (i % 3 == 0 ? 1.7 : 1.0) + 1e-5 * (1 + i) * (1 - 0.4 * e);
    energies::StretchChunk chunk{};
    chunk.count = chunk.stride = points;
    chunk.sigma = sigma, chunk.psi = psi;
    chunk.gradient = rest, chunk.diagonal = rest + 3 * points, chunk.twist = rest + 6 * points;
    chunk.flip = rest + 9 * points;
    double coupling[3 * points];
    chunk.coupling = coupling;
    energy.evaluate_derivatives(3, chunk);
    chunk.psi = alone;
    energy.evaluate_psi(3, chunk);
    for (int i = 0; i < points; ++i) CHECK(psi[i] == alone[i]);
  }

  TEST_CASE("conditions and functions without a rule are what they are near rest, too") {
    const auto value = [](const std::string& text, double s1, double s2) {
      const AnyEnergy energy = expressions::parse_energy(text);
      double sigma[16], psi[8];
      std::fill_n(sigma, 8, s1), std::fill_n(sigma + 8, 8, s2);
      energies::StretchChunk chunk{};
      chunk.count = chunk.stride = 8;
      chunk.sigma = sigma, chunk.psi = psi;
      energy.evaluate_psi(2, chunk);
      return psi[0];
    };
    CHECK(value("if(J < 1, I2, 2*I2 - 2)", 1.01, 0.98) ==
          doctest::Approx(1.01 * 1.01 + 0.98 * 0.98).epsilon(1e-15));
    CHECK(value("if(J < 1, I2, 2*I2 - 2)", 1.03, 0.98) ==
          doctest::Approx(2 * (1.03 * 1.03 + 0.98 * 0.98) - 2));
    CHECK(value("abs(J - 1) + sin(I1) + max(I1, 2)", 1.02, 0.99) ==
          doctest::Approx(std::abs(1.02 * 0.99 - 1) + std::sin(2.01) + 2.01).epsilon(1e-14));
    CHECK(value("sqrt(J - 1 + 1e-30) + I2", 1.02, 0.99) ==
          doctest::Approx(std::sqrt(1.02 * 0.99 - 1) + 1.02 * 1.02 + 0.99 * 0.99));
    CHECK(value("1/(I1 - 2) + I2", 1.02, 0.99) == doctest::Approx(1 / 0.01 + 1.02 * 1.02 + 0.99 * 0.99));
    CHECK(value("log(J)^3 + tan(J)", 1.02, 0.99) ==
          doctest::Approx(std::pow(std::log(1.0098), 3) + std::tan(1.0098)));
  }
}
