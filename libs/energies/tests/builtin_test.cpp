// Every built-in energy against itself: all its forms and witnesses say the same.
#include "builtins.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

using namespace isostretch;
using namespace isostretch::energies;
using namespace isostretch::energies::tests;

namespace {

// sigma_0 >= sigma_1 >= ..., moderate.
template <int Dim>
std::vector<PrincipalStretches<Dim, double>> moderate_stretches() {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(0.5, 2.0);
  std::vector<PrincipalStretches<Dim, double>> all;
  for (int n = 0; n < 50; ++n) {
    PrincipalStretches<Dim, double> s;
    for (double& sigma : s.sigma) sigma = uniform(generator);
    std::sort(s.sigma, s.sigma + Dim, std::greater<>());
    all.push_back(s);
  }
  return all;
}

template <int Dim>
double size_of(const Derivatives<Dim>& d) {
  double sum = std::abs(d.psi);
  for_each_entry<Dim>(d, d, [&](const char*, double value, double) { sum += std::abs(value); });
  return sum;
}

template <int Dim>
void check_equal(const Derivatives<Dim>& a, const Derivatives<Dim>& b, double tolerance) {
  const double size = size_of<Dim>(a);
  CHECK(std::abs(a.psi - b.psi) <= tolerance * size);
  for_each_entry<Dim>(a, b, [&](const char* what, double x, double y) {
    CAPTURE(std::string(what));
    CHECK(std::abs(x - y) <= tolerance * size);
  });
}

void check_equal(const Partials<double>& a, const Partials<double>& b) {
  const double x[] = {a.psi, a.P1, a.P2, a.P3, a.P11, a.P22, a.P33, a.P12, a.P23, a.P13};
  const double y[] = {b.psi, b.P1, b.P2, b.P3, b.P11, b.P22, b.P33, b.P12, b.P23, b.P13};
  double size = 0;
  for (const double value : x) size += std::abs(value);
  for (int i = 0; i < 10; ++i) {
    CAPTURE(i);
    CHECK(std::abs(x[i] - y[i]) <= 1e-12 * size);
  }
}

// psi(I), hand-written partials, jets and the forms in sigma at one stretch.
template <int Dim, class Energy>
void check_forms(const Energy& energy, const PrincipalStretches<Dim, double>& s) {
  Derivatives<Dim> direct;
  energy.derivatives(s, direct);
  CHECK(energy.psi(s) == doctest::Approx(direct.psi).epsilon(1e-13));
  if constexpr (requires { energy.psi(s.invariants()); }) {
    const auto jets = invariants::partials_by_jets(energy, s.invariants());
    CHECK(std::abs(jets.psi - direct.psi) <= 1e-11 * size_of<Dim>(direct));
    Derivatives<Dim> generic;
    invariants::derivatives_from_partials(s, jets, generic);
    check_equal<Dim>(direct, generic, 1e-10);
    if constexpr (requires { energy.partials(s.invariants()); })
      check_equal(energy.partials(s.invariants()), jets);
  }
}

template <int Dim, class Energy>
void check_levels(const Energy& energy, const PrincipalStretches<Dim, double>& s) {
  Derivatives<Dim> direct;
  energy.derivatives(s, direct);
  at_every_level([&](Isa isa) {
    CAPTURE(isa_name(isa));
    PointChunk<Dim> point(s);
    check_equal<Dim>(point.derivatives(energy), direct, 1e-12);
    CHECK(point.psi(energy) == doctest::Approx(point.derivatives(energy).psi).epsilon(1e-13));
  });
}

template <int Dim, class Energy>
void check_domain(const Energy& energy) {
  const AnyEnergy any = energy;
  at_every_level([&](Isa isa) {
    CAPTURE(isa_name(isa));
    for (const double smallest : {0.0, -1e-12, -0.5, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
      CAPTURE(smallest);
      PrincipalStretches<Dim, double> s;
      for (double& sigma : s.sigma) sigma = 1.0;
      s.sigma[Dim - 1] = smallest;
      PointChunk<Dim> point(s);
      if (any.has_barrier()) {
        CHECK(point.psi(any) == std::numeric_limits<double>::infinity());
        CHECK(point.derivatives(any).psi == std::numeric_limits<double>::infinity());
      } else if (!std::isnan(smallest)) {
        // sigma_j + sigma_k = 0 at smallest = -1: finite by convention, whatever the limit.
        CHECK(std::isfinite(point.psi(any)));
        CHECK(std::isfinite(size_of<Dim>(point.derivatives(any))));
      }
    }
  });
}

template <int Dim, class Energy>
void check_in(const Energy& energy) {
  if constexpr (supports<Energy>(Dim)) {
    CAPTURE(Dim);
    for (const auto& s : moderate_stretches<Dim>()) {
      check_forms<Dim>(energy, s);
      check_levels<Dim>(energy, s);
    }
    check_domain<Dim>(energy);
  }
}

}  // namespace

TEST_CASE("forms in sigma, partials, jets and all levels agree; domains are guarded") {
  for_each_varied_builtin([](auto energy) {
    const std::string name = energy.name;
    CAPTURE(name);
    check_in<2>(energy);
    check_in<3>(energy);
  });
}

TEST_CASE("energies said to be decoupled are, and the others are not") {
  for_each_varied_builtin([](auto energy) {
    using Energy = decltype(energy);
    const std::string name = energy.name;
    CAPTURE(name);
    constexpr int dim = supports<Energy>(3) ? 3 : 2;
    double largest = 0;
    for (const auto& s : moderate_stretches<dim>()) {
      Derivatives<dim> d;
      energy.derivatives(s, d);
      for (const double coupling : d.coupling) largest = std::max(largest, std::abs(coupling));
    }
    CHECK((largest > 0) == AnyEnergy(energy).coupled());
  });
}
