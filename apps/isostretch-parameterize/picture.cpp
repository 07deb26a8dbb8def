#include "common/figures/solve_figure.hpp"
#include "common/formatted.hpp"
#include "report.hpp"

namespace isostretch::app::parameterize {
namespace {

std::vector<double> distortions(const std::vector<double>& stretches) {
  std::vector<double> values;
  for (std::size_t i = 0; i + 1 < stretches.size(); i += 2)
    values.push_back(figures::distortion(stretches[i], stretches[i + 1]));
  return values;
}

std::string size_text(const Result& r) {
  std::string text = with_thousands(r.domain.open().triangles.rows()) + " triangles";
  if (r.start.charts.size() > 1) text += " in " + std::to_string(r.start.charts.size()) + " charts";
  if (r.layout.packed) text += formatted(", %.0f %% of the unit square", 100 * r.layout.coverage);
  return text;
}

std::string subtitle(const Result& r) {
  const newton::Summary& s = r.solution.summary;
  return size_text(r) +
         formatted(
             "   ·   %s after %d iterations, %.3g s   ·   energy %.10g   ·   |gradient|∞ %.2e   ·   "
             "%zu flipped%s",
             std::string(newton::status_name(s.status)).c_str(), s.iterations, s.seconds.total, s.energy,
             s.gradient_inf_norm, r.layout.flipped.size(), r.layout.flipped.empty() ? "" : " (blue)");
}

}  // namespace

std::string draw_layout(const Result& r) {
  const std::vector<double> values = distortions(r.solution.stretches);
  const std::vector<int> pinned = r.solution.pins.nodes();
  return figures::draw_solve(
      {.title = r.options.model.filename().string() + ", " + r.energy.name(),
       .subtitle = subtitle(r),
       .layout = {r.layout.uv, r.domain.open().triangles, values, r.layout.flipped, pinned,
                  r.options.units() == UvUnits::square, &r.layout.overlap.triangles},
       .areas = r.start.rest.weights,
       .trace = r.solution.summary.trace,
       .chart_of_row = r.solution.chart_of_row});
}

}  // namespace isostretch::app::parameterize
