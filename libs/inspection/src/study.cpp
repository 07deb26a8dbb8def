#include <isostretch/inspection/study.hpp>

#include <isostretch/expressions/expression.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::inspection {
namespace {

using energies::AnyEnergy;

Rest at_rest(const AnyEnergy& energy, int dim) {
  const Spectrum s = spectrum(energy, dim, {1, 1, 1});
  if (!s.in_domain()) return {s, RestKind::outside};
  if (std::abs(s.stress[0]) > rounding * s.size()) return {s, RestKind::stressed};
  if (s.is_negative(Mode::flip) || s.is_negative(Mode::scaling)) return {s, RestKind::saddle};
  const bool strict = s.is_positive(Mode::flip) && s.is_positive(Mode::scaling);
  return {s, strict ? RestKind::minimum : RestKind::degenerate};
}

// ---- examples ----

// Round numbers in the range, and its ends.
std::vector<double> amounts(const StretchRange& range) {
  std::vector<double> all{range.low};
  for (const double amount :
       {0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.0, 1.1, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0})
    if (amount > range.low && amount < range.high) all.push_back(amount);
  all.push_back(range.high);
  return all;
}

struct Kind {
  const char* name;
  int dim;           // 0: both
  bool beyond_rest;  // amounts above 1 alone: below it the same come again
  Stretches (*at)(double amount);
};
constexpr Kind kinds[] = {{"uniform", 0, false,
                           [](double a) {
                             return Stretches{a, a, a};
                           }},
                          {"uniaxial", 0, false,
                           [](double a) {
                             return Stretches{a, 1, 1};
                           }},
                          {"shear", 0, true,
                           [](double a) {
                             return Stretches{a, 1 / a, 1};
                           }},
                          {"biaxial", 3, false,
                           [](double a) {
                             return Stretches{a, a, 1};
                           }},
                          {"uniaxial, volume kept", 3, false, [](double a) {
                             return Stretches{a, 1 / std::sqrt(a), 1 / std::sqrt(a)};
                           }}};

std::vector<Example> examples(const AnyEnergy& energy, int dim, const StretchRange& range) {
  std::vector<Example> all;
  for (const Kind& kind : kinds)
    for (const double amount : amounts(range)) {
      const bool again = amount == 1 && &kind != &kinds[0];
      if ((kind.dim != 0 && kind.dim != dim) || again || (kind.beyond_rest && amount < 1)) continue;
      all.push_back({kind.name, spectrum(energy, dim, kind.at(amount))});
    }
  return all;
}

// ---- samples ----

// All s1 >= s2 >= s3 of a logarithmic grid.
std::vector<Stretches> grid(int dim, const StretchRange& range, int points) {
  std::vector<double> values;
  for (int i = 0; i < points; ++i)
    values.push_back(range.low * std::pow(range.high / range.low, static_cast<double>(i) / (points - 1)));
  std::vector<Stretches> all;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      if (dim == 2) all.push_back({values[i], values[j], 1});
      for (std::size_t k = 0; dim == 3 && k <= j; ++k) all.push_back({values[i], values[j], values[k]});
    }
  return all;
}

Sample sampled(const AnyEnergy& energy, int dim, const StretchRange& range) {
  Sample sample;
  for (const Spectrum& s : spectra(energy, dim, grid(dim, range, dim == 2 ? 200 : 50))) {
    if (!s.in_domain()) {
      ++sample.outside;
      continue;
    }
    for (const Mode mode : all_modes) {
      ModeRecord& record = sample.modes[static_cast<std::size_t>(mode)];
      if (sample.count == 0 || s.least(mode) < record.worst.least(mode)) record.worst = s;
      record.negative += s.is_negative(mode);
    }
    ++sample.count;
  }
  return sample;
}

// ---- where it is convex ----

// The last amount on the way from `from` to `to` up to which `holds`, which it does at `from`.
template <class Holds>
double last_holding(double from, double to, const Holds& holds) {
  constexpr int steps = 60, halvings = 40;
  const auto at = [&](double t) { return from * std::pow(to / from, t); };
  double good = 0, bad = 1;
  for (int i = 1; i <= steps; ++i) {
    bad = static_cast<double>(i) / steps;
    if (!holds(at(bad))) break;
    good = bad;
  }
  if (good == 1) return to;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (good + bad);
    (holds(at(middle)) ? good : bad) = middle;
  }
  return at(good);
}

bool is_convex(const Spectrum& s, bool twist_too) {
  return s.in_domain() && !(twist_too && s.is_negative(Mode::twist)) && !s.is_negative(Mode::flip) &&
         !s.is_negative(Mode::scaling);
}

Convexity convexity(const AnyEnergy& energy, int dim, const StretchRange& range) {
  Convexity result;
  result.largest_box = std::min(range.high, 1 / range.low);
  const auto uniform = [&](double s) { return is_convex(spectrum(energy, dim, {s, s, s}), true); };
  if (uniform(1))
    result.uniform = StretchRange{last_holding(1, range.low, uniform), last_holding(1, range.high, uniform)};
  const auto box = [&](bool twist_too) {
    return [&energy, dim, twist_too](double r) {
      const auto all = spectra(energy, dim, grid(dim, {1 / r, r}, dim == 2 ? 33 : 13));
      return std::all_of(all.begin(), all.end(), [=](const Spectrum& s) { return is_convex(s, twist_too); });
    };
  };
  if (box(true)(1)) result.box = last_holding(1, result.largest_box, box(true));
  if (box(false)(1)) result.box_without_twist = last_holding(1, result.largest_box, box(false));
  return result;
}

}  // namespace

Study study(const AnyEnergy& energy, const std::string& source, int dim, const StretchRange& range) {
  Study result{dim,
               at_rest(energy, dim),
               examples(energy, dim, range),
               sampled(energy, dim, range),
               convexity(energy, dim, range),
               {}};
  if (expressions::is_expression(source)) result.formulas = expressions::print_derivatives(source, dim);
  return result;
}

}  // namespace isostretch::inspection
