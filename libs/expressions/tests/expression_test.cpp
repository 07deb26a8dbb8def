#include <isostretch/core/isa.hpp>
#include <isostretch/expressions/expression.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace isostretch;
using energies::AnyEnergy;
using expressions::parse_energy;

namespace {

template <int Dim>
double psi_at(const AnyEnergy& energy, const invariants::PrincipalStretches<Dim, double>& s) {
  constexpr int points = 16;
  std::vector<double> sigma(Dim * points), psi(points);
  for (int e = 0; e < Dim; ++e)
    for (int i = 0; i < points; ++i) sigma[static_cast<std::size_t>(e * points + i)] = s[e];
  energies::StretchChunk chunk;
  chunk.count = points;
  chunk.stride = points;
  chunk.sigma = sigma.data();
  chunk.psi = psi.data();
  energy.evaluate_psi(Dim, chunk);
  for (const double value : psi) CHECK((value == psi[0] || (value != value && psi[0] != psi[0])));
  return psi[0];
}

const invariants::PrincipalStretches<3, double> probe{{1.5, 1.2, 0.8}};

double value(const std::string& text, const std::map<std::string, double>& parameters = {}) {
  return psi_at(parse_energy(text, parameters), probe);
}

void check_refused(const std::string& text, const std::string& why, std::size_t position) {
  CAPTURE(text);
  try {
    parse_energy(text);
    FAIL("it was not refused");
  } catch (const expressions::ExpressionError& error) {
    const std::string message = error.what();
    CAPTURE(message);
    CHECK(message.find(why) != std::string::npos);
    CHECK(error.position() == position);
    CHECK(message.ends_with("\n  " + text + "\n  " + std::string(position, ' ') + "^"));
  }
}

}  // namespace

TEST_SUITE("expressions") {
  TEST_CASE("precedence and associativity are those of mathematics") {
    const double J = 1.5 * 1.2 * 0.8;
    CHECK(value("J - 1 - 2") == doctest::Approx(J - 3).epsilon(1e-15));
    CHECK(value("8/J/2*3") == doctest::Approx(8 / J / 2 * 3).epsilon(1e-15));
    CHECK(value("-J^2") == doctest::Approx(-J * J).epsilon(1e-15));
    CHECK(value("2^-J") == doctest::Approx(std::exp2(-J)).epsilon(1e-15));
    CHECK(value("J^2^3") == doctest::Approx(std::pow(J, 8)).epsilon(1e-14));
    CHECK(value("(J^2)^3") == doctest::Approx(std::pow(J, 6)).epsilon(1e-14));
    CHECK(value("2*-J + +1") == doctest::Approx(1 - 2 * J).epsilon(1e-15));
    CHECK(value("1.5e-1*J + .5") == doctest::Approx(0.15 * J + 0.5).epsilon(1e-15));
  }

  TEST_CASE("functions, conditions, names and parameters") {
    const double I1 = 3.5, I2 = 1.5 * 1.5 + 1.2 * 1.2 + 0.64, J = 1.5 * 1.2 * 0.8;
    CHECK(value("I1 + I2 + I3 + d") == doctest::Approx(I1 + I2 + J + 3).epsilon(1e-15));
    CHECK(value("sqrt(J) + cbrt(J) + exp(J) + log(J) + expm1(J) + log1p(J)") ==
          doctest::Approx(std::sqrt(J) + std::cbrt(J) + std::exp(J) + std::log(J) + std::expm1(J) +
                          std::log1p(J))
              .epsilon(1e-14));
    CHECK(value("sin(J) + cos(J) + tan(J) + sinh(J) + cosh(J) + tanh(J) + atan(J) + abs(J - 2)") ==
          doctest::Approx(std::sin(J) + std::cos(J) + std::tan(J) + std::sinh(J) + std::cosh(J) +
                          std::tanh(J) + std::atan(J) + std::abs(J - 2))
              .epsilon(1e-14));
    CHECK(value("pow(J, 1.7) + min(J, 2) + max(J, 2) + pi + e") ==
          doctest::Approx(std::pow(J, 1.7) + J + 2 + 3.14159265358979 + 2.71828182845905).epsilon(1e-13));
    CHECK(value("if(J < 2 && I1 >= 3, 1, 2)*J") == doctest::Approx(J));
    CHECK(value("(!(J > 2) || I1 < 0 ? 5 : 7)*J") == doctest::Approx(5 * J));
    CHECK(value("sum(s^3)") ==
          doctest::Approx(1.5 * 1.5 * 1.5 + 1.2 * 1.2 * 1.2 + 0.8 * 0.8 * 0.8).epsilon(1e-14));
    CHECK(value("a*J + b_2", {{"a", 3}, {"b_2", -1}}) == doctest::Approx(3 * J - 1).epsilon(1e-15));
  }

  TEST_CASE("what is wrong is said where it is wrong") {
    check_refused("I2 + ", "something is missing at the end", 5);
    check_refused("I2 + * 3", "a number, a name or '('", 5);
    check_refused("mu*I2", "'mu' is neither a variable nor a parameter", 0);
    check_refused("log(I2", "')' is missing after one argument", 6);
    check_refused("I2)", "something left over", 2);
    check_refused("foo(I2)", "there is no function 'foo'", 0);
    check_refused("I2 + system(1)", "there is no function 'system'", 5);
    check_refused("if(I2, 1, 2)", "if() wants a condition first", 3);
    check_refused("(J < 1) + 2", "a number is wanted here, and this is a condition", 0);
    check_refused("J < 1", "a number is wanted here", 0);
    check_refused("s + 1", "'s' stands for each stretch inside of sum()", 0);
    check_refused("sum(sum(s))", "sum() inside of sum()", 4);
    check_refused("1e999*I2", "not a number that double can hold", 0);
    check_refused("I2 + \"x\"", "a number, a name or '('", 5);
    check_refused("I2 $ 3", "something left over", 3);
    check_refused("", "something is missing", 0);
  }

  TEST_CASE("parameters that are missing, left over or not finite are named") {
    CHECK_THROWS_WITH_AS(parse_energy("a*I2", {{"a", 1}, {"b", 2}}),
                         doctest::Contains("parameter 'b' does not occur"), Error);
    CHECK_THROWS_WITH_AS(parse_energy("a*I2", {{"a", std::numeric_limits<double>::quiet_NaN()}}),
                         doctest::Contains("parameter 'a'"), Error);
  }

  TEST_CASE("what is no isotropic energy is refused") {
    CHECK_THROWS_WITH_AS(parse_energy("s1^2 + s2"), doctest::Contains("no isotropic energy (in 2D)"), Error);
    CHECK_THROWS_WITH_AS(parse_energy("s1*s2 + s3"), doctest::Contains("no isotropic energy (in 3D)"), Error);
    CHECK_THROWS_WITH_AS(parse_energy("log(-I2)"), doctest::Contains("not finite at any stretch"), Error);
  }

  TEST_CASE("length, depth and size are bounded") {
    CHECK_THROWS_WITH_AS(parse_energy("I2" + std::string(5000, ' ')), doctest::Contains("characters"), Error);
    for (const char* open : {"(", "-", "sqrt(", "2^", "if(1<2,1,", "!", "1+("}) {
      CAPTURE(open);
      std::string deep;
      while (deep.size() < 3000) deep += open;
      CHECK_THROWS_AS(parse_energy(deep + "I2"), Error);
    }
    std::string tower = "J";
    for (int i = 0; i < 80; ++i) tower = std::string("exp(-").append(tower).append("*I2)");
    CHECK_NOTHROW(parse_energy(tower));
    std::string wide = "sum(s)";
    while (wide.size() < 3900) wide += "*sin(" + std::to_string(wide.size()) + "+sum(s^2)*J)";
    try {
      parse_energy(wide);  // fits, or is refused by its size
    } catch (const Error& error) {
      CHECK(std::string(error.what()).find("operations") != std::string::npos);
    }
  }

  TEST_CASE("a name is no expression unless it is a variable's") {
    for (const char* expression : {"I2", "J", "I1 + 1", "2*mu", "", "1"})
      CHECK(expressions::is_expression(expression));
    for (const char* name : {"arap", "my_energy_2", "mu"}) CHECK_FALSE(expressions::is_expression(name));
    CHECK(expressions::parameter_names("mu*(I2 - d) + 1e5*log (J) - k_1*sum(s^2)") ==
          std::set<std::string>{"k_1", "mu"});
  }

  TEST_CASE("the dimensions of an energy are what it mentions") {
    CHECK((parse_energy("I2").supports(2) && parse_energy("I2").supports(3)));
    CHECK((parse_energy("sum(s)").supports(2) && parse_energy("sum(s)").supports(3)));
    CHECK((parse_energy("s1 + s2").supports(2) && !parse_energy("s1 + s2").supports(3)));
    CHECK((!parse_energy("s1*s2*s3").supports(2) && parse_energy("s1*s2*s3").supports(3)));
  }

  TEST_CASE("energies whose scaling modes decouple are known") {
    for (const char* decoupled : {"I2 - 2*I1 + d", "sum(s^2 + 1/s^2)", "sum(log(s)^2)"})
      CHECK_FALSE(parse_energy(decoupled).coupled());
    for (const char* coupled : {"I2 + (J - 1)^2", "I1^2", "sum(s)^2", "s1*s2"})
      CHECK(parse_energy(coupled).coupled());
  }

  TEST_CASE("barriers are found where there are some") {
    for (const char* barrier :
         {"I2 - log(J)", "I2/J", "I2 + J^-2", "I2*J^(-2/3)", "sum(1/s^2)", "I2 + J*log(J)", "I2 + sqrt(J)",
          "sum(log(s)^2)", "I2 + exp(1/J)", "I2 - 1e-3*log(abs(J))", "I2 + if(J > 0.1, 0, 1/0)",
          "I2 + max(log(J), 0)", "I2 + max(0, log(J))", "I2 + J^2.5"}) {
      CAPTURE(barrier);
      const AnyEnergy energy = parse_energy(barrier);
      CHECK(energy.determinant_bound() == 0);
      CHECK(psi_at<3>(energy, {{1, 0.7, -0.5}}) == std::numeric_limits<double>::infinity());
    }
    for (const char* finite :
         {"I2", "I2 - 2*I1 + d", "(J - 1)^2", "I2 + J^2*log(I2 + 1)", "sum((s^2 - 1)^2)", "I2 + abs(J)",
          "exp(I2/10)", "I2 + 1/(1 + J^2)", "I2 + if(J < 1, (J - 1)^2, 0)"}) {
      CAPTURE(finite);
      const AnyEnergy energy = parse_energy(finite);
      CHECK(!energy.has_barrier());
      CHECK(std::isfinite(psi_at<3>(energy, {{1, 0.7, -0.5}})));
    }
  }

  // Against quotients where stretches are apart, and against the limit where they are equal.
  TEST_CASE("flips of every function and of conditions do not cancel") {
    const auto d = [](const AnyEnergy& energy, double a, double b) {
      return energies::derivatives_at(energy, invariants::PrincipalStretches<2, double>{{a, b}});
    };
    for (const char* text : {"sum(sqrt(s))",
                             "sum(cbrt(s))",
                             "sum(exp(s))",
                             "sum(expm1(s))",
                             "sum(log(s))",
                             "sum(log1p(s))",
                             "sum(sin(s))",
                             "sum(cos(s))",
                             "sum(tan(s))",
                             "sum(sinh(s))",
                             "sum(cosh(s))",
                             "sum(tanh(s))",
                             "sum(atan(s))",
                             "sum(abs(s - 2)^3)",
                             "sum(s^2.3)",
                             "sum(s^-0.7)",
                             "sum((s - 1)^18)",
                             "sum(1/s^3)",
                             "sum(min(s, 1)^3)",
                             "sum(max(s, 1)^2)",
                             "sum(if(s < 1, (s - 1)^2, 2*(s - 1)^2))",
                             "if(sum(s) > 3, sum(s^3), sum(s^2))",
                             "exp(-sum(1/s))",
                             "sum(s^3)*sum(log(s))/J"}) {
      CAPTURE(text);
      const AnyEnergy energy = parse_energy(text);
      for (const double s : {0.6, 1.3}) {
        const auto equal = d(energy, s, s), near = d(energy, s + 1e-7, s), apart = d(energy, s + 0.2, s);
        const double size = 1 + std::abs(equal.diagonal[0]);
        CHECK(std::abs(equal.flip[0] - (equal.diagonal[0] - equal.coupling[0])) < 1e-10 * size);
        CHECK(std::abs(near.flip[0] - equal.flip[0]) < 1e-5 * size);
        CHECK(std::abs(apart.flip[0] - (apart.gradient[0] - apart.gradient[1]) / 0.2) < 1e-10 * size);
      }
      for (const auto& [a, b] : {std::pair(1.2, 0.8), std::pair(1.0, 0.9), std::pair(1.0, 1.0)})
        CHECK(std::isfinite(d(energy, a, b).flip[0]));
    }
    CHECK(d(parse_energy("sum(exp(-1/s))"), 1, 1e-3).flip[0] == doctest::Approx(std::exp(-1) / 0.999));
  }

  TEST_CASE("flips of steep functions keep their digits where stretches are apart") {
    using S = invariants::PrincipalStretches<2, double>;
    const std::pair<const char*, S> cases[] = {{"sum(1/expm1(1/(s-1)^2)) + I2", {{1.3, 1.1}}},
                                               {"sum(sinh(s^3)^-2)", {{5, 0.7}}},
                                               {"sum(exp(s^2)/(1+exp(s^2))^2)", {{10, 0.5}}},
                                               {"sum(cosh(5*(s-1))^-2)", {{10, 0.5}}},
                                               {"sum(1/(1+s^17)^3)", {{10, 0.5}}},
                                               {"sum((1+s^6)^-2)", {{10, 0.5}}},
                                               {"sum(sin(exp(-1/(s-1)^2)))+I2", {{1.0372, 1.037}}},
                                               {"I2 + abs(0.3*s1 - 0.3*s2)", {{1.3, 1.1}}}};
    for (const auto& one : cases) {
      const auto& [text, s] = one;
      CAPTURE(one.first);
      const auto d = energies::derivatives_at(parse_energy(text), s);
      const double exact = (d.gradient[0] - d.gradient[1]) / (s[0] - s[1]);
      CHECK(std::abs(d.flip[0] - exact) <= 1e-11 * std::abs(exact));
    }
    // No quotient of two things that are too small.
    for (const char* text : {"sum(sinh((s-1)^34)) + I2", "sum(tanh(1e-300*s^2)) + I2"}) {
      CAPTURE(text);
      const auto d = energies::derivatives_at(parse_energy(text), S{{1 + 1e-9, 1 - 1e-9}});
      CHECK(d.flip[0] == doctest::Approx(2));
    }
  }

  TEST_CASE("every instruction set gives the same to rounding") {
    const AnyEnergy energy =
        parse_energy("sum(log(s)^2) + I2^1.3*cbrt(J) + sin(I1) + max(J, 1.1) + if(I1 > 3, tanh(I1), 0)");
    const Isa active = active_isa();
    set_isa(Isa::base);
    const auto scalar = energies::derivatives_at(energy, probe);
    for (const Isa isa : available_isas()) {
      set_isa(isa);
      const auto d = energies::derivatives_at(energy, probe);
      CHECK(d.psi == doctest::Approx(scalar.psi).epsilon(1e-13));
      for (int i = 0; i < 3; ++i) {
        CHECK(d.twist[i] == doctest::Approx(scalar.twist[i]).epsilon(1e-12));
        CHECK(d.flip[i] == doctest::Approx(scalar.flip[i]).epsilon(1e-12));
        CHECK(d.diagonal[i] == doctest::Approx(scalar.diagonal[i]).epsilon(1e-12));
      }
    }
    set_isa(active);
  }
}
