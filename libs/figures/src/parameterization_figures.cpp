#include <isostretch/figures/parameterization_figures.hpp>

#include <isostretch/core/text.hpp>
#include <isostretch/figures/checkerboard.hpp>
#include <isostretch/figures/model_figure.hpp>
#include <isostretch/figures/solve_figure.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/surface/seams.hpp>

#include <array>
#include <vector>

namespace isostretch::figures {
namespace {

using parameterization::Parameterization;

std::vector<double> distortions(const std::vector<double>& stretches) {
  std::vector<double> values;
  for (std::size_t i = 0; i + 1 < stretches.size(); i += 2)
    values.push_back(distortion(stretches[i], stretches[i + 1]));
  return values;
}

// What the picture itself shows, in words; more is in the report.
std::string layout_subtitle(const Parameterization& r) {
  std::string text = with_thousands(r.domain.open().triangles.rows()) + " triangles in " +
                     std::to_string(r.start.charts.size()) +
                     (r.start.charts.size() == 1 ? " chart" : " charts");
  if (r.layout.packed) text += formatted(", %.0f %% of the square", 100 * r.layout.coverage);
  if (!r.layout.overlap.triangles.empty())
    text += "   ·   " + share_text(r.layout.overlap.share()) + " lies under more than one triangle (hatched)";
  if (!r.layout.flipped.empty()) text += formatted("   ·   %zu flipped (blue)", r.layout.flipped.size());
  return text + (r.solution.summary.converged() ? "   ·   converged" : "   ·   not converged");
}

// Where the surface is cut, and where it ends.
std::vector<std::array<int, 2>> outlines(const parameterization::Domain& domain) {
  std::vector<std::array<int, 2>> lines = mesh::edges_of(domain.input.triangles).boundary;
  for (const mesh::Edge& edge : domain.cut.seams) lines.push_back({edge.low, edge.high});
  return lines;
}

std::string model_subtitle(const Parameterization& r, double square) {
  std::string text = formatted("squares of side %.3g where lengths are kept, in units of the model",
                               square / r.layout.scale);
  if (!r.domain.cut.seams.empty())
    text += formatted("   ·   seams: %zu edges, length %.3g", r.domain.cut.seams.size(),
                      mesh::seam_length(r.domain.input.vertices, r.domain.cut.seams));
  if (!r.layout.flipped.empty()) text += formatted("   ·   %zu flipped (blue)", r.layout.flipped.size());
  return text;
}

}  // namespace

std::string share_text(double share) {
  return formatted(share < 0.095 ? "%.2g %%" : "%.0f %%", 100 * share);
}

std::string draw_layout(const ParameterizationFigure& figure) {
  const Parameterization& r = figure.result;
  const std::vector<double> values = distortions(r.solution.stretches);
  const std::vector<int> pinned = r.solution.pins.nodes();
  return draw_solve({.title = figure.title,
                     .subtitle = layout_subtitle(r),
                     .layout = {r.layout.uv, r.domain.open().triangles, values, r.layout.flipped, pinned,
                                figure.unit_square, &r.layout.overlap.triangles},
                     .areas = r.start.rest.weights,
                     .trace = r.solution.summary.trace,
                     .chart_of_row = r.solution.chart_of_row});
}

std::string draw_model(const ParameterizationFigure& figure) {
  const Parameterization& r = figure.result;
  const double square = checker_square(r);
  return draw_model(
      ModelFigure{.title = figure.title,
                  .subtitle = model_subtitle(r, square),
                  .model = {r.domain.input.vertices, r.domain.input.triangles, r.layout.uv,
                            r.domain.open().triangles, square, r.layout.flipped, outlines(r.domain)}});
}

std::string textured_glb(const Parameterization& result) {
  const double repeats = 1 / (checker_square(result) * texture_cells);
  return mesh::format_glb(result.textured(), {.base_color_png = checker_texture(), .repeats = repeats});
}

}  // namespace isostretch::figures
