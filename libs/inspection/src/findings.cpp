#include <isostretch/inspection/findings.hpp>

#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/expressions/expression.hpp>

#include <cmath>

namespace isostretch::inspection {
namespace {

// Of a stretch as near to 1 as rounding lets it come.
bool is_one(double stretch) {
  return std::abs(std::log(stretch)) < 1e-6;
}

std::string number(double value) {
  return formatted("%.4g", value);
}

// Equal neighbours once, with their count.
std::string values_text(const std::array<double, 3>& values, int count, double size) {
  const auto cleaned = [&](int i) {
    const double value = values[static_cast<std::size_t>(i)];
    return number(std::abs(value) <= 1e-12 * size ? 0 : value);
  };
  std::string text;
  for (int i = 0; i < count;) {
    int same = 1;
    while (i + same < count && cleaned(i + same) == cleaned(i)) ++same;
    text += (i > 0 ? ", " : "") + cleaned(i) + (same > 1 ? formatted(" (%dx)", same) : "");
    i += same;
  }
  return text;
}

std::string modes_text(const Spectrum& s, Mode mode) {
  return values_text(s.of(mode), s.count(mode), s.size());
}

std::string rest_text(const Study& study) {
  switch (study.rest.kind) {
    case RestKind::minimum:
      return "yes, but for rotations, which change nothing";
    case RestKind::degenerate:
      return "not decided by second derivatives: some change of shape costs nothing to second order";
    case RestKind::saddle:
      return "no: the Hessian has negative eigenvalues";
    case RestKind::stressed:
      return "no: it is not free of stress";
    case RestKind::outside:
      break;
  }
  return "no: it is outside of the domain";
}

// Of r: within [1/r, r].
std::string box_text(double r, double largest) {
  if (is_one(r)) return "in no neighbourhood of rest";
  return formatted("within [%.4g, %.4g]", 1 / r, r) + (r < largest ? "" : ", as far as the range goes");
}

std::string uniform_text(const Convexity& convexity, const StretchRange& range) {
  if (!convexity.uniform) return "not at rest";
  const auto [low, high] = *convexity.uniform;
  if (is_one(low) && is_one(high)) return "at rest alone";
  std::string text = formatted("within [%.4g, %.4g]", low, high);
  if (low == range.low && high == range.high) return text + ", as far as the range goes";
  if (low == range.low || high == range.high)
    text += formatted(", where %.4g is the end of the range", low == range.low ? low : high);
  return text;
}

std::string share_text(double share) {
  return share == 0       ? "nowhere"
         : share < 0.0005 ? "in less than 0.1 %"
                          : formatted("in %.1f %%", 100 * share);
}

}  // namespace

Findings inspect(const energies::AnyEnergy& energy, const std::string& source, const StretchRange& range,
                 std::optional<int> dim) {
  Findings findings{energy, source, range, {}};
  for (const int each : {2, 3})
    if (energy.supports(each) && dim.value_or(each) == each)
      findings.studies.push_back(study(energy, source, each, range));
  return findings;
}

std::string dimension_name(const Study& study) {
  return formatted("in %dD", study.dim);
}

std::string stretches_text(const Spectrum& s) {
  return s.dim == 2 ? formatted("(%.4g, %.4g)", s.at[0], s.at[1])
                    : formatted("(%.4g, %.4g, %.4g)", s.at[0], s.at[1], s.at[2]);
}

Facts energy_facts(const Findings& f) {
  std::string parameters, dimensions;
  for (const auto& parameter : f.energy.parameters())
    parameters += (parameters.empty() ? "" : ", ") + parameter.name + " = " + to_text(parameter.value);
  for (const int dim : {2, 3})
    if (f.energy.supports(dim)) dimensions += (dimensions.empty() ? "" : " and ") + formatted("%dD", dim);
  const double bound = f.energy.determinant_bound();
  return {{expressions::is_expression(f.source) ? "expression" : "energy", f.energy.name()},
          {"parameters", parameters.empty() ? "none" : parameters},
          {"exists in", dimensions},
          {"inversion", f.energy.has_barrier() ? formatted("barrier: infinite at det F <= %.4g", bound)
                                               : std::string("finite at any F, inverted ones as well")}};
}

Facts rest_facts(const Study& study) {
  const Rest& rest = study.rest;
  const Spectrum& s = rest.spectrum;
  if (rest.kind == RestKind::outside) return {{"minimum", rest_text(study)}};
  const std::string moduli =
      rest.stress_free() ? "" : "; tangent moduli only, since rest is not free of stress";
  return {{"psi", formatted("%.10g", s.psi)},
          {"stress", rest.stress_free() ? "0: free of stress" : number(s.stress[0]) + " in every direction"},
          {"mu", number(rest.mu()) + " (flip = 2 mu = " + modes_text(s, Mode::flip) + ")" + moduli},
          {"lambda", number(rest.lambda()) + formatted(" (2 mu + lambda = %.4g)", s.diagonal) + moduli},
          {"twist", modes_text(s, Mode::twist)},
          {"minimum", rest_text(study)}};
}

Facts convexity_facts(const Study& study, const StretchRange& range) {
  const Convexity& c = study.convexity;
  return {{"uniform stretches", uniform_text(c, range)},
          {"all stretches", box_text(c.box, c.largest_box)},
          {"all, twists aside", box_text(c.box_without_twist, c.largest_box)}};
}

Rows mode_rows(const Study& study) {
  Rows rows;
  if (study.sample.count == 0) return rows;
  for (const Mode mode : all_modes) {
    const Spectrum& worst = study.sample.of(mode).worst;
    rows.push_back({mode_name(mode), share_text(study.sample.share(mode)), number(worst.least(mode)),
                    stretches_text(worst)});
  }
  return rows;
}

std::string sample_text(const Study& study) {
  const Sample& sample = study.sample;
  return with_thousands(sample.count) + " samples of a logarithmic grid" +
         (sample.outside > 0 ? ", " + with_thousands(sample.outside) + " more outside of the domain" : "");
}

Rows example_rows(const Study& study) {
  Rows rows;
  for (const Example& example : study.examples) {
    const Spectrum& s = example.spectrum;
    if (!s.in_domain()) {
      rows.push_back({example.kind, stretches_text(s), "outside of the domain", "", "", "", ""});
      continue;
    }
    rows.push_back({example.kind, stretches_text(s), formatted("%.5g", s.psi),
                    values_text(s.stress, s.dim, s.size()), modes_text(s, Mode::twist),
                    modes_text(s, Mode::flip), modes_text(s, Mode::scaling)});
  }
  return rows;
}

Facts formula_facts(const Study& study) {
  Facts facts;
  for (const auto& [name, text] : study.formulas)
    if (text != "0") facts.emplace_back(name, text.empty() ? "(too long to print)" : text);
  return facts;
}

std::string zero_formulas(const Study& study) {
  std::string names;
  for (const auto& [name, text] : study.formulas)
    if (text == "0") names += (names.empty() ? "" : ", ") + name;
  return names;
}

std::string verdict(const Findings& findings) {
  std::string text;
  for (const Study& study : findings.studies) {
    std::string negative;
    for (const Mode mode : all_modes)
      if (study.sample.of(mode).negative > 0) negative += (negative.empty() ? "" : ", ") + mode_name(mode);
    text += (text.empty() ? "" : "; ") + dimension_name(study) + " rest is " +
            (study.rest.kind == RestKind::minimum      ? "a minimum"
             : study.rest.kind == RestKind::degenerate ? "free of stress"
             : study.rest.kind == RestKind::outside    ? "outside of the domain"
                                                       : "no minimum") +
            (negative.empty() ? ", no eigenvalue is negative in the sample"
                              : ", negative in the sample: " + negative);
  }
  return text;
}

}  // namespace isostretch::inspection
