#include <isostretch/figures/axis.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace isostretch::figures {
namespace {

std::string power_of_ten(int exponent) {
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
  return text;
}

std::string number(double value) {
  const double exponent = std::log10(std::abs(value));
  if (exponent == std::round(exponent) && exponent >= 4) return power_of_ten(static_cast<int>(exponent));
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

// The smallest of 1, 2, 5 times a power of ten that is not below the value.
double round_up(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * decade >= value * (1 - 1e-9)) return factor * decade;
  return 10 * decade;
}

std::vector<Tick> even_ticks(double low, double high, double step) {
  std::vector<Tick> ticks;
  const double slack = 1e-9 * step;
  for (double i = std::ceil((low - slack) / step); i * step <= high + slack; ++i)
    ticks.push_back({i * step, number(i * step + 0.0)});  // + 0.0: -0 is 0
  return ticks;
}

// 1, 2, 5 times powers of ten, or the powers alone.
std::vector<Tick> log_ticks(double low, double high, bool powers_only) {
  std::vector<Tick> ticks;
  for (double decade = std::pow(10.0, std::floor(std::log10(low))); decade <= high; decade *= 10)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = factor * decade;
      if (value >= low && value <= high && (factor == 1.0 || !powers_only))
        ticks.push_back({value, number(value)});
    }
  return ticks;
}

}  // namespace

double Axis::position(double value) const {
  if (logarithmic) return std::log(value / low) / std::log(high / low);
  return (value - low) / (high - low);
}

Axis linear_axis(double high, int most_ticks, bool whole) {
  if (!(high > 0)) high = 1;
  double step = round_up(high / (most_ticks - 1));
  if (whole) step = std::max(step, 1.0);
  Axis axis{0, high, false, {}};
  axis.ticks = even_ticks(0, high, step);
  return axis;
}

Axis decade_axis(double low, double high, int most_ticks) {
  int first = static_cast<int>(std::floor(std::log10(low)));
  int last = static_cast<int>(std::ceil(std::log10(high)));
  if (first == last) ++last;
  Axis axis{std::pow(10.0, first), std::pow(10.0, last), true, {}};
  const int every = 1 + (last - first) / most_ticks;
  for (int e = first; e <= last; ++e)
    axis.ticks.push_back({std::pow(10.0, e), (last - e) % every == 0 ? power_of_ten(e) : std::string()});
  return axis;
}

Axis narrow_log_axis(double low, double high, int most_ticks) {
  Axis axis{low, high, true, {}};
  axis.ticks = log_ticks(low, high, high / low > 3000);
  if (high / low < 5) axis.ticks = even_ticks(low, high, round_up((high - low) / (most_ticks - 1)));
  return axis;
}

}  // namespace isostretch::figures
