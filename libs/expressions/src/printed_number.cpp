#include "printed_number.hpp"

#include <charconv>
#include <cmath>
#include <utility>

namespace isostretch::expressions {
namespace {

constexpr double rounding = 2e-15;

// The value as p / q with q up to `most`, or over 1.
Fraction fraction(double value, double most) {
  // Convergents of the continued fraction.
  double p = 1, q = 0, p_before = 0, q_before = 1, rest = value;
  for (int i = 0; i < 20; ++i) {
    const double whole = std::floor(rest);
    const double p_next = whole * p + p_before, q_next = whole * q + q_before;
    if (q_next > most || std::abs(p_next) > 1e9) break;
    p_before = std::exchange(p, p_next), q_before = std::exchange(q, q_next);
    if (std::abs(p / q - value) <= rounding * std::abs(value)) return {p, q};
    rest = 1 / (rest - whole);
  }
  return {value, 1};
}

}  // namespace

bool is_whole(double value) {
  return std::abs(value) < 1e15 && value == std::round(value);
}

std::string shortest(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

Fraction readable(double value) {
  constexpr std::size_t is_short = 8;
  constexpr double small = 12, large = 1e6;
  const Fraction simple = fraction(value, small);
  if (is_whole(simple.above) || shortest(value).size() <= is_short) return simple;
  return fraction(value, large);
}

double snapped(double value) {
  constexpr double simple = 12;
  const Fraction f = fraction(value, simple);
  return f.above / f.below;
}

}  // namespace isostretch::expressions
