#include <isostretch/energies/registry.hpp>
#include <isostretch/expressions/expression.hpp>
#include <isostretch/inspection/findings.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace isostretch;
using namespace isostretch::inspection;

TEST_CASE("inspection: the spectrum has the second derivatives of psi, by differences") {
  const energies::AnyEnergy energy = energies::make_energy("symmetric_dirichlet");
  for (const int dim : {2, 3}) {
    const Stretches at{1.3, 1.1, 0.8};
    constexpr double h = 1e-4;
    const auto psi = [&](double first, double second) {
      return spectrum(energy, dim, {at[0] + first, at[1] + second, at[2]}).psi;
    };
    const Spectrum s = spectrum(energy, dim, at);
    CHECK(s.in_domain());
    CHECK(s.stress[0] == doctest::Approx((psi(h, 0) - psi(-h, 0)) / (2 * h)).epsilon(1e-6));
    CHECK(s.diagonal == doctest::Approx((psi(h, 0) - 2 * psi(0, 0) + psi(-h, 0)) / (h * h)).epsilon(1e-5));
    const double mixed = (psi(h, h) - psi(h, -h) - psi(-h, h) + psi(-h, -h)) / (4 * h * h);
    CHECK(std::abs(s.coupling - mixed) < 1e-5 * s.size());
  }
}

TEST_CASE("inspection: many stretches give what each gives alone, whatever the chunk") {
  const energies::AnyEnergy energy = energies::make_energy("symmetric_dirichlet");
  std::vector<Stretches> all;
  for (int i = 0; i < 130; ++i) all.push_back({1 + 0.01 * i, 1, 1 - 0.005 * i});
  const std::vector<Spectrum> together = spectra(energy, 3, all);
  REQUIRE(together.size() == all.size());
  for (const std::size_t i : {std::size_t{0}, std::size_t{63}, std::size_t{64}, std::size_t{129}}) {
    const Spectrum alone = spectrum(energy, 3, all[i]);
    CHECK(together[i].psi == alone.psi);
    CHECK(together[i].least() == alone.least());
  }
}

TEST_CASE("inspection: twists of ARAP are negative where the stretches add up to less than 2") {
  const energies::AnyEnergy energy = energies::make_energy("arap");
  const Study found = study(energy, "arap", 2, {0.3, 3});
  CHECK(found.rest.stress_free());
  CHECK(found.sample.outside == 0);
  CHECK(found.sample.of(Mode::twist).negative > 0);
  CHECK(found.sample.of(Mode::flip).negative == 0);
  CHECK(found.sample.of(Mode::scaling).negative == 0);
  const Spectrum& worst = found.sample.of(Mode::twist).worst;
  CHECK(worst.at[0] == doctest::Approx(0.3));
  CHECK(worst.least(Mode::twist) / worst.least(Mode::flip) == doctest::Approx(1 - 2 / 0.6));
  CHECK(found.convexity.box == doctest::Approx(1));
  CHECK(found.convexity.box_without_twist == found.convexity.largest_box);
  REQUIRE(found.convexity.uniform.has_value());
  CHECK(found.convexity.uniform->low == doctest::Approx(1));
  CHECK(found.convexity.uniform->high == 3);
}

TEST_CASE("inspection: moduli, kind of rest and formulas of an expression") {
  const std::string text = "mu/2*(I2-d) - mu*log(J)";
  const energies::AnyEnergy energy = expressions::parse_energy(text, {{"mu", 3}});
  const Findings findings = inspect(energy, text, {0.5, 2});
  REQUIRE(findings.studies.size() == 2);
  for (const Study& found : findings.studies) {
    CHECK(found.rest.kind == RestKind::minimum);
    CHECK(found.rest.mu() == doctest::Approx(3));
    CHECK(std::abs(found.rest.lambda()) < 1e-12);
    CHECK(!found.formulas.empty());
    CHECK(!formula_facts(found).empty());
  }
  CHECK(verdict(findings).find("in 2D rest is a minimum") == 0);
  CHECK(inspect(energy, text, {0.5, 2}, 3).studies.size() == 1);
}

TEST_CASE("inspection: rest of an energy that is stressed there") {
  const std::string text = "I2";
  const Study found = study(expressions::parse_energy(text, {}), text, 3, {0.5, 2});
  CHECK(found.rest.kind == RestKind::stressed);
  CHECK(!found.rest.stress_free());
  CHECK(example_rows(found).size() == found.examples.size());
  CHECK(mode_rows(found).size() == 3);
}
