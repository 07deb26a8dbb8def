#include "outcome.hpp"
#include "report.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/figures/solve_figure.hpp>

namespace isostretch::app::parameterize {
namespace {

std::vector<double> distortions(const std::vector<double>& stretches) {
  std::vector<double> values;
  for (std::size_t i = 0; i + 1 < stretches.size(); i += 2)
    values.push_back(figures::distortion(stretches[i], stretches[i + 1]));
  return values;
}

// What the picture itself shows, in words; more is in the report.
std::string subtitle(const Result& r) {
  std::string text = with_thousands(r.domain.open().triangles.rows()) + " triangles in " +
                     std::to_string(r.start.charts.size()) +
                     (r.start.charts.size() == 1 ? " chart" : " charts");
  if (r.layout.packed) text += formatted(", %.0f %% of the square", 100 * r.layout.coverage);
  if (!r.layout.overlap.triangles.empty())
    text += "   ·   " + share_text(r.layout.overlap.share()) + " lies under more than one triangle (hatched)";
  if (!r.layout.flipped.empty()) text += formatted("   ·   %zu flipped (blue)", r.layout.flipped.size());
  return text + (r.solution.summary.converged() ? "   ·   converged" : "   ·   not converged");
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
