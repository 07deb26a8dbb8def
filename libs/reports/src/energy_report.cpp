#include <isostretch/reports/energy_report.hpp>

#include "json.hpp"

#include <isostretch/core/version.hpp>
#include <isostretch/expressions/expression.hpp>

#include <algorithm>

namespace isostretch::reports {
namespace {

using namespace inspection;

// ---- text ----

std::string aligned(const Rows& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line = "  ";
    for (std::size_t c = 0; c < row.size(); ++c)
      line += row[c] + std::string(widths[c] - row[c].size() + 2, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string aligned(const Facts& facts) {
  Rows rows;
  for (const auto& [name, text] : facts) rows.push_back({name, text});
  return aligned(rows);
}

template <std::size_t N>
std::string table(const char* const (&columns)[N], Rows rows) {
  rows.insert(rows.begin(), std::vector<std::string>(columns, columns + N));
  return aligned(rows);
}

std::string formula_text(const Study& study) {
  std::string text;
  for (const auto& [name, formula] : formula_facts(study)) text += "  " + name + " = " + formula + "\n";
  if (const std::string zeros = zero_formulas(study); !zeros.empty()) text += "  0: " + zeros + "\n";
  return text;
}

std::string study_text(const Study& study, const StretchRange& range) {
  const std::string where = dimension_name(study);
  std::string text = "\nAt rest, " + where + "\n" + aligned(rest_facts(study));
  text += "\nNegative eigenvalues, " + where + " (" + sample_text(study) + ")\n" +
          table(mode_columns, mode_rows(study));
  text += "\nThe Hessian is positive semi-definite, " + where + "\n" + aligned(convexity_facts(study, range));
  text += "\nExamples, " + where + "\n" + table(example_columns, example_rows(study));
  if (!study.formulas.empty()) text += "\nDerivatives, " + where + "\n" + formula_text(study);
  return text;
}

// ---- JSON ----

Json stretches_json(const Spectrum& s) {
  return Json(std::vector<double>(s.at.begin(), s.at.begin() + s.dim));
}

Json values_json(const Spectrum& s, Mode mode) {
  return Json(std::vector<double>(s.of(mode).begin(), s.of(mode).begin() + s.count(mode)));
}

Json spectrum_json(const Spectrum& s) {
  Json json{{"stretches", stretches_json(s)}, {"in_domain", s.in_domain()}};
  if (!s.in_domain()) return json;
  json["psi"] = s.psi;
  json["stress"] = std::vector<double>(s.stress.begin(), s.stress.begin() + s.dim);
  for (const Mode mode : all_modes) json[mode_name(mode)] = values_json(s, mode);
  return json;
}

Json rest_json(const Rest& rest) {
  Json json = spectrum_json(rest.spectrum);
  json["kind"] = name_of(rest_names, rest.kind);
  if (rest.kind == RestKind::outside) return json;
  json["stress_free"] = rest.stress_free();
  json["mu"] = rest.mu();
  json["lambda"] = rest.lambda();
  json["diagonal"] = rest.spectrum.diagonal;
  return json;
}

Json sample_json(const Sample& sample) {
  Json json{{"samples", sample.count}, {"outside_of_domain", sample.outside}};
  if (sample.count == 0) return json;
  for (const Mode mode : all_modes) {
    const ModeRecord& record = sample.of(mode);
    json[mode_name(mode)] = {{"negative", record.negative},
                             {"share", sample.share(mode)},
                             {"least", record.worst.least(mode)},
                             {"at", stretches_json(record.worst)}};
  }
  return json;
}

Json convexity_json(const Convexity& c) {
  Json json;
  json["uniform"] = c.uniform ? Json{c.uniform->low, c.uniform->high} : Json();
  json["box"] = c.box;
  json["box_without_twist"] = c.box_without_twist;
  json["largest_box"] = c.largest_box;
  return json;
}

Json study_json(const Study& study) {
  Json examples = Json::array(), formulas = Json::object();
  for (const Example& example : study.examples) {
    examples.push_back({{"kind", example.kind}});
    examples.back().update(spectrum_json(example.spectrum));
  }
  for (const auto& [name, text] : study.formulas) formulas[name] = text.empty() ? Json() : Json(text);
  return {{"dim", study.dim},
          {"rest", rest_json(study.rest)},
          {"negative", sample_json(study.sample)},
          {"convex", convexity_json(study.convexity)},
          {"examples", examples},
          {"formulas", formulas}};
}

}  // namespace

std::string report_text(const inspection::Findings& f) {
  std::string text = aligned(energy_facts(f));
  for (const Study& study : f.studies) text += study_text(study, f.range);
  return text + "\n";
}

std::string summary_text(const inspection::Findings& f) {
  Json studies = Json::array(), dimensions = Json::array();
  for (const Study& study : f.studies) studies.push_back(study_json(study));
  for (const int dim : {2, 3})
    if (f.energy.supports(dim)) dimensions.push_back(dim);
  return file_text({{"message", verdict(f)},
                    {"energy_name", f.energy.name()},
                    {"is_expression", expressions::is_expression(f.source)},
                    {"energy_parameters", parameters_of(f.energy)},
                    {"dimensions", dimensions},
                    {"has_barrier", f.energy.has_barrier()},
                    {"range", {f.range.low, f.range.high}},
                    {"studies", studies},
                    {"version", version_string}});
}

}  // namespace isostretch::reports
