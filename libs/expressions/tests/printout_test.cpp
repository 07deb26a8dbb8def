#include "typed_builtins.hpp"

#include <isostretch/expressions/expression.hpp>
#include <isostretch/expressions/printout.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <cmath>

using namespace isostretch;
using expressions::parse_energy;
using expressions::print_derivatives;
using Parameters = std::map<std::string, double>;

namespace {

// With stretches as parameters: a mode of one pair is not symmetric, and no energy by itself.
std::string with_fixed_stretches(const std::string& text) {
  const auto in_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = i == 0 || !in_name(text[i - 1]);
    const bool is_stretch = begins && text[i] == 's' && i + 1 < text.size() && text[i + 1] >= '1' &&
                            text[i + 1] <= '3' && (i + 2 == text.size() || !in_name(text[i + 2]));
    result += is_stretch ? "fixed_s" : std::string(1, text[i]);
  }
  return result;
}

template <int Dim>
double value_of(const std::string& formula, const Parameters& parameters,
                const invariants::PrincipalStretches<Dim, double>& s) {
  const std::string text = with_fixed_stretches(formula);
  Parameters all = parameters;
  for (int i = 0; i < Dim; ++i) all["fixed_s" + std::to_string(i + 1)] = s[i];
  const auto used = expressions::parameter_names(text);
  std::erase_if(all, [&](const auto& entry) { return !used.contains(entry.first); });
  return energies::derivatives_at(parse_energy(text, all), s).psi;
}

template <int Dim>
class Printed {
 public:
  Printed(const std::string& text, const Parameters& parameters,
          invariants::PrincipalStretches<Dim, double> s)
      : parameters_(parameters), s_(s) {
    for (const expressions::Formula& printed : print_derivatives(text, Dim)) {
      REQUIRE_MESSAGE(!printed.text.empty(), printed.name);
      formulas_[printed.name] = printed.text;
    }
  }

  bool has(const std::string& name) const { return formulas_.contains(name); }
  double value(const std::string& name) const {
    CAPTURE(name);
    CAPTURE(formulas_.at(name));
    return value_of<Dim>(formulas_.at(name), parameters_, s_);
  }

 private:
  std::map<std::string, std::string> formulas_;
  Parameters parameters_;
  invariants::PrincipalStretches<Dim, double> s_;
};

template <int Dim>
void check_values(const std::string& text, const Parameters& parameters,
                  const invariants::PrincipalStretches<Dim, double>& s) {
  const auto energy = parse_energy(text, parameters);
  if (!energy.supports(Dim)) return;
  CAPTURE(text);
  CAPTURE(Dim);
  const auto d = energies::derivatives_at(energy, s);
  const Printed<Dim> printed(text, parameters, s);
  const std::string mode = Dim == 2 ? "" : "_1";
  const double twist = printed.value("twist" + mode), flip = printed.value("flip" + mode);
  double size = std::abs(d.twist[0]);
  for (const double entry : {d.flip[0], d.diagonal[0], d.coupling[Dim == 2 ? 0 : 2]})
    size = std::max(size, std::abs(entry));
  const auto same = [&](double a, double b) { return std::abs(a - b) <= 1e-11 * size; };
  CHECK(same(twist, d.twist[0]));
  CHECK(same(flip, d.flip[0]));
  CHECK(same(printed.value("A_11"), d.diagonal[0]));
  CHECK(same(printed.value("A_12"), d.coupling[Dim == 2 ? 0 : 2]));
  if (!printed.has("psi_I1")) {
    CHECK(same(printed.value("psi_1"), d.gradient[0]));
    return;
  }
  const double P2 = printed.value("psi_I2"), volume = s.c(0) * printed.value("psi_J");
  CHECK(same(2 * printed.value("psi_I1") / (s.a(0) + s.b(0)) + 2 * P2 + volume, d.twist[0]));
  CHECK(same(2 * P2 - volume, d.flip[0]));
  // Euler's relation for the slope along s: second partials by chain rule against A.
  const double by_1 = printed.value("psi_I1I1") + 2 * (s[0] + s[1]) * printed.value("psi_I1I2") +
                      4 * s[0] * s[1] * printed.value("psi_I2I2");
  const double g[] = {s.others(0), s.others(1)};
  const double by_J = g[0] * g[1] * printed.value("psi_JJ") + (g[0] + g[1]) * printed.value("psi_I1J") +
                      2 * (s[0] * g[1] + s[1] * g[0]) * printed.value("psi_I2J");
  const double left = Dim == 2 ? 1 : s[Dim - 1];
  CHECK(same(by_1 + by_J + left * printed.value("psi_J"), d.coupling[Dim == 2 ? 0 : 2]));
}

void check_both(const std::string& text, const Parameters& parameters) {
  check_values<2>(text, parameters, {{1.3, 0.8}});
  check_values<2>(text, parameters, {{1.1, 0.7}});
  check_values<3>(text, parameters, {{1.3, 1.1, 0.8}});
  check_values<3>(text, parameters, {{1.2, 0.9, 0.6}});
}

std::string formula(const std::string& text, const std::string& name, int dim = 3) {
  for (const auto& entry : print_derivatives(text, dim))
    if (entry.name == name) return entry.text;
  return "none";
}

}  // namespace

TEST_SUITE("printed derivatives") {
  TEST_CASE("of the built-in energies as typed read back to the same values") {
    for (const auto& typed : tests::typed_builtins()) check_both(typed.text, typed.parameters);
  }

  TEST_CASE("of other functions, conditions and exponents that are parameters, too") {
    check_both("if(I2*J^(-2/d) - d < m, -m/2*log(1 - (I2*J^(-2/d) - d)/m), 1/0) + (J^2 - 1)/4 - log(J)/2",
               {{"m", 20}});
    check_both("c*(I2*J^(-2/d) - d)^3 + J^n - n*log1p(J) + b^J", {{"c", 0.3}, {"n", 1.7}, {"b", 1.4}});
    check_both("a*(sum((s*J^(-1/d))^m) - d) + (I1 - d)^2", {{"a", 0.7}, {"m", 1.3}});
    check_both("tanh(I1 - 2) + max(J, 0.9) + min(I2, 10) + abs(J - 2) + atan(I2) + cbrt(J) + sqrt(I2 + J)",
               {});
    check_both("sum(sin(s) + exp(s/3) + cosh(s)) + if(J > 0.1 && !(I1 < 1), I1*I2, 0)", {});
    check_both("sum(abs(s - 0.5)) + (I1 - J)^-2.5/(1 + I2)^(1/3)", {});
  }

  TEST_CASE("are as short as a reader would write them") {
    const std::string neo_hookean = "mu/2*(I2 - d) - mu*log(J) + lambda/2*log(J)^2";
    CHECK(formula(neo_hookean, "psi_I1") == "0");
    CHECK(formula(neo_hookean, "psi_I2") == "mu/2");
    CHECK(formula(neo_hookean, "psi_J") == "(lambda*log(J) - mu)/J");
    CHECK(formula(neo_hookean, "flip", 2) == "mu + mu/J - lambda*log(J)/J");
    CHECK(formula("I2 - 2*I1 + d", "twist_1") == "2 - 4/(s2 + s3)");
    CHECK(formula("I2 - 2*I1 + d", "twist", 2) == "2 - 4/I1");
    CHECK(formula("sum(s^2 + 1/s^2)/2", "A_11") == "1 + 3/s1^4");
    CHECK(formula("mu*sum(log(s)^2)", "psi_1") == "2*mu*log(s1)/s1");
    CHECK(formula("(J - 1)^2*k/2", "A_11") == "k*s2^2*s3^2");
    CHECK(formula("I1/I1*I2*I2^1.5", "psi_I2") == "5*I2^(3/2)/2");
    CHECK(formula("J^a + J^(-a)", "psi_J") == "a*(J^a - J^(-a))/J");
  }

  TEST_CASE("that are too long are left out, and dimensions that there are not refused") {
    std::string wide = "sin(J)";
    while (wide.size() < 1500) wide += "*sin(" + std::to_string(wide.size()) + "+I2*J)";
    bool left_out = false;
    for (const auto& entry : print_derivatives(wide, 3)) {
      CHECK(entry.text.size() <= expressions::max_length);
      left_out |= entry.text.empty();
    }
    CHECK(left_out);
    CHECK_THROWS_WITH_AS(print_derivatives("s1*s2*s3", 2), doctest::Contains("does not exist in 2D"), Error);
    CHECK_THROWS_AS(print_derivatives("I2 + *", 2), expressions::ExpressionError);
  }
}
