#include "typed_builtins.hpp"

#include <isostretch/energies/registry.hpp>
#include <isostretch/expressions/expression.hpp>
#include <isostretch/mesh/element_arrays.hpp>
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
    for (const auto& typed : tests::typed_builtins()) {
      const AnyEnergy built = energies::make_energy(typed.name, typed.parameters);
      if (!built.supports(3) || typed.name == "log_barrier") continue;  // that one alone has no minimum
      CAPTURE(typed.name);
      const auto a = iterates(expressions::parse_energy(typed.text, typed.parameters)), b = iterates(built);
      REQUIRE(a.size() > 1);
      REQUIRE(a.size() == b.size());
      for (std::size_t i = 0; i < a.size(); ++i) CHECK((a[i] - b[i]).norm() <= 1e-8 * b[i].norm());
    }
  }
}
