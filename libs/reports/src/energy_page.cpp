#include <isostretch/reports/energy_report.hpp>

#include <isostretch/core/version.hpp>
#include <isostretch/figures/html.hpp>
#include <isostretch/figures/report_style.hpp>

namespace isostretch::reports {
namespace {

using namespace inspection;
namespace html = figures::html;

std::string heading(const std::string& text) {
  return html::block("h2", html::escaped(text));
}

std::string fact_table(const Facts& facts) {
  Rows rows;
  for (const auto& [name, text] : facts) rows.push_back({name, text});
  return html::table({{}, {}}, rows);
}

template <std::size_t N>
std::string wide_table(const char* const (&names)[N], const Rows& rows) {
  std::vector<html::Column> columns;
  for (const char* name : names) columns.push_back({name});
  return html::block("div", html::table(columns, rows), "class=\"wide\"");
}

std::string formula_table(const Study& study) {
  Facts facts = formula_facts(study);
  if (const std::string zeros = zero_formulas(study); !zeros.empty()) facts.emplace_back("0", zeros);
  const std::string pairs = study.dim == 2 ? "" : " twist_1 and flip_1 are those of the pair (s2, s3);";
  return fact_table(facts) +
         html::block(
             "p", html::escaped("J is I3;" + pairs +
                                " those of other axes follow by exchanging stretches. Every text reads back "
                                "as an expression."));
}

std::string study_section(const Study& study, const StretchRange& range, const std::string& map) {
  const std::string where = dimension_name(study);
  std::string text = heading("At rest, " + where) + fact_table(rest_facts(study));
  text += html::figure(map, "psi and the smallest eigenvalue of its Hessian, " + where,
                       "Left: psi above its least value, logarithmic. Right: the smallest eigenvalue of the "
                       "Hessian; blue where it is negative, the line is its zero. Both axes are logarithmic" +
                           std::string(study.dim == 3 ? "; s3 = 1." : "."));
  text += heading("Negative eigenvalues, " + where) +
          html::block("p", html::escaped(sample_text(study) + ".")) +
          wide_table(mode_columns, mode_rows(study));
  text += heading("Where the Hessian is positive semi-definite, " + where) +
          fact_table(convexity_facts(study, range));
  text += heading("Examples, " + where) + wide_table(example_columns, example_rows(study));
  if (!study.formulas.empty()) text += heading("Derivatives, " + where) + formula_table(study);
  return text;
}

}  // namespace

std::string report_page(const inspection::Findings& f, const std::vector<std::string>& maps) {
  std::string body = html::block("h1", html::escaped(f.energy.name()));
  body += html::block("p", html::escaped(verdict(f) + "."), "class=\"verdict\"");
  body += fact_table(energy_facts(f));
  for (std::size_t i = 0; i < f.studies.size(); ++i) body += study_section(f.studies[i], f.range, maps[i]);
  body += html::block("footer", "isostretch-energy " + std::string(version_string));
  return html::page(f.energy.name(), html::report_style, body);
}

}  // namespace isostretch::reports
