#include "parameterization_summary.hpp"

#include <isostretch/figures/html.hpp>
#include <isostretch/figures/report_style.hpp>

namespace isostretch::reports {
namespace {

namespace html = figures::html;
using Result = ParameterizationReport;

std::string verdict_box(const Result& r) {
  const std::string what = html::block("p", html::escaped(html::sentence(outcome(r))), "class=\"verdict\"");
  if (status(r) == RunStatus::success) return what;
  return html::block("p", html::escaped(html::sentence(verdict(r))), "class=\"verdict bad\"") + what;
}

}  // namespace

std::string report_page(const Result& r, const RunFacts& facts, const std::string& model_png,
                        const std::string& layout_png) {
  const Json summary = summary_json(r, facts);
  const std::string name = r.model.filename().string();
  std::string body =
      html::block("h1", html::escaped(name)) + verdict_box(r) + html::warnings(page_warnings(summary));
  body += html::figure(
      model_png, "The model with the layout on it as a checkerboard",
      "The model from the front and from behind. Squares keep their size and shape where the layout "
      "keeps lengths; dark lines are seams and boundaries.");
  body += html::figure(
      layout_png, "The layout, coloured by distortion, and the convergence of the solve",
      "The layout. Pale where lengths are kept, dark where they are not; right, how the energy and "
      "its gradient fell.");
  body += html::block("h2", "Facts") + fact_tables(summary);
  body += html::block("h2", "Charts") + chart_table(summary.at("charts"));
  body += html::block("h2", "Options") + option_table(summary);
  body += html::block("footer", "isostretch-parameterize " + summary.at("version").get<std::string>());
  return html::page(name + ", flattened", html::report_style, body);
}

}  // namespace isostretch::reports
