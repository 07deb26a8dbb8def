// Random and hostile texts: evaluated as an independent evaluator does, or refused with a message.
#include "precise_evaluator.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/expressions/expression.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

using namespace isostretch;

namespace {

// Sound expressions of the invariants, of a given depth.
class Writer {
 public:
  explicit Writer(unsigned seed) : generator_(seed) {}

  std::string number(int depth) {
    if (depth == 0) return leaf();
    const auto inner = [&] { return number(depth - 1); };
    switch (pick(9)) {
      case 0:
        return joined({inner(), " + ", inner()});
      case 1:
        return joined({inner(), "*(", inner(), ")"});
      case 2:
        return joined({"(", inner(), ")/(", inner(), ")"});
      case 3:
        return joined({"-", leaf(), "^", std::to_string(pick(5))});
      case 4:
        return joined({"(", inner(), ")^", exponents[pick(7)]});
      case 5:
        return joined({functions[pick(14)], "(", inner(), ")"});
      case 6:
        return joined({"if(", condition(depth - 1), ", ", inner(), ", ", inner(), ")"});
      case 7:
        return joined({pick(2) ? "min(" : "max(", inner(), ",", inner(), ")"});
      default:
        return joined({"(", condition(depth - 1), " ? ", leaf(), " : ", inner(), ") - ", leaf()});
    }
  }

  // Anything at all.
  std::string noise() {
    static const char* const parts[] = {
        "I1",  "I2", "J",  "(",  ")",  "+", "-",  "*",  "/",  "^",    "log(", "sum(",  "s",
        "if(", ",",  "?",  ":",  "<",  "1", "0",  "..", "1e", "e5",   "\"",   "\\",    "%s",
        "$(",  ";",  "\n", "s1", "s3", "!", "&&", "||", "=",  "\xff", "pow(", "1e308", " "};
    std::string text;
    for (int i = pick(24); i >= 0; --i) text += parts[pick(static_cast<int>(std::size(parts)))];
    return text;
  }

 private:
  static constexpr const char* functions[] = {"sqrt", "cbrt", "exp",  "expm1", "log",  "log1p", "sin",
                                              "cos",  "tan",  "sinh", "cosh",  "tanh", "atan",  "abs"};
  static constexpr const char* exponents[] = {"2", "3", "-1", "0.5", "-1.7", "(1/3)", "17"};

  static std::string joined(std::initializer_list<std::string> parts) {
    std::string text;
    for (const std::string& part : parts) text += part;
    return text;
  }
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(generator_); }
  std::string leaf() {
    static const char* const leaves[] = {"I1", "I2", "J", "I3", "d", "0.3", "2", "1e-3", "(I1 - 2)"};
    return leaves[pick(static_cast<int>(std::size(leaves)))];
  }
  std::string condition(int depth) {
    static const char* const comparisons[] = {" < ", " <= ", " > ", " >= "};
    const std::string text = joined({number(depth), comparisons[pick(4)], leaf()});
    return pick(3) == 0 ? joined({"!(", text, ") || J < 1.5"}) : text;
  }

  std::mt19937 generator_;
};

double psi_at(const energies::AnyEnergy& energy, double a, double b, double c) {
  std::vector<double> sigma(24), psi(8);
  for (std::size_t i = 0; i < 8; ++i) sigma[i] = a, sigma[8 + i] = b, sigma[16 + i] = c;
  energies::StretchChunk chunk;
  chunk.count = 8;
  chunk.stride = 8;
  chunk.sigma = sigma.data();
  chunk.psi = psi.data();
  energy.evaluate_psi(3, chunk);
  return psi[0];
}

// The same text at invariants that differ by `change`, relatively: what rounding may do to it.
long double precise(const std::string& text, double a, double b, double c, long double change) {
  const long double more = 1 + change;
  const std::map<std::string, long double> names{{"I1", (0.0L + a + b + c) * more},
                                                 {"I2", (1.0L * a * a + 1.0L * b * b + 1.0L * c * c) / more},
                                                 {"I3", 1.0L * a * b * c * more},
                                                 {"J", 1.0L * a * b * c * more},
                                                 {"d", 3.0L}};
  return tests::PreciseEvaluator(text, names).run();
}

}  // namespace

TEST_SUITE("fuzzed expressions") {
  TEST_CASE("sound expressions have the value that an independent evaluator finds") {
    Writer writer(11);
    const double points[][3] = {{1, 1, 1}, {1.3, 1.1, 0.7}, {2.1, 0.9, 0.4}};
    int compared = 0, refused = 0;
    for (int i = 0; i < 5000; ++i) {
      const std::string text = writer.number(1 + i % 4);
      CAPTURE(text);
      try {
        const auto energy = expressions::parse_energy(text);
        if (!energy.supports(3)) {  // nowhere finite in space
          ++refused;
          continue;
        }
        for (const auto& [a, b, c] : points) {
          const double got = psi_at(energy, a, b, c);
          const long double expected = precise(text, a, b, c, 0);
          if (!std::isfinite(static_cast<double>(expected))) {
            CHECK(!(got < std::numeric_limits<double>::infinity()));
            continue;
          }
          long double spread = 0;
          for (const long double change : {1e-14L, -1e-14L, 3e-14L, -3e-14L})
            spread = std::max(spread, std::abs(precise(text, a, b, c, change) - expected));
          // A jump, or a pole, within rounding: nothing can be said.
          if (!(spread <= 1e-6L * (1 + std::abs(expected)))) continue;
          CHECK(std::abs(got - expected) <= 10 * spread + 1e-13L * (1 + std::abs(expected)));
          ++compared;
        }
      } catch (const Error& error) {
        CHECK(std::string(error.what()).size() > 10);
        ++refused;
      }
    }
    CHECK(compared > 8000);
    CHECK(refused < 1000);
  }

  TEST_CASE("noise is evaluated or refused") {
    Writer writer(12);
    int refused = 0;
    for (int i = 0; i < 5000; ++i) {
      const std::string text = writer.noise();
      try {
        const auto energy = expressions::parse_energy(text);
        if (energy.supports(3)) psi_at(energy, 1.2, 1, 0.9);
      } catch (const Error& error) {
        CHECK(std::string(error.what()).size() > 10);
        ++refused;
      }
    }
    CHECK(refused > 3000);
  }
}
