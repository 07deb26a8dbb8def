#include "report_page.hpp"

#include "common/html.hpp"
#include "common/report_style.hpp"
#include "outcome.hpp"
#include "report_tables.hpp"
#include "report_warnings.hpp"

#include <nlohmann/json.hpp>

namespace isostretch::app::parameterize {
namespace {

std::string verdict_box(const Result& r) {
  const std::string what = html::block("p", html::escaped(html::sentence(outcome(r))), "class=\"verdict\"");
  if (exit_code(r) == ExitCode::success) return what;
  return html::block("p", html::escaped(html::sentence(verdict(r))), "class=\"verdict bad\"") + what;
}

}  // namespace

std::string report_page(const Result& r, const Json& summary, const Pictures& pictures) {
  const std::string name = r.options.model.filename().string();
  std::string body =
      html::block("h1", html::escaped(name)) + verdict_box(r) + html::warnings(report_warnings(summary));
  body += html::figure(
      pictures.model, "The model with the layout on it as a checkerboard",
      "The model from the front and from behind. Squares keep their size and shape where the layout "
      "keeps lengths; dark lines are seams and boundaries.");
  body += html::figure(
      pictures.layout, "The layout, coloured by distortion, and the convergence of the solve",
      "The layout. Pale where lengths are kept, dark where they are not; right, how the energy and "
      "its gradient fell.");
  body += html::block("h2", "Facts") + facts(summary);
  body += html::block("h2", "Charts") + chart_table(summary.at("charts"));
  body += html::block("h2", "Options") + option_table(summary);
  body += html::block("footer", "isostretch-parameterize " + summary.at("version").get<std::string>());
  return html::page(name + ", flattened", report_style, body);
}

}  // namespace isostretch::app::parameterize
