#include <isostretch/comparison/manipulation_pictures.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/figures/deformation_figure.hpp>
#include <isostretch/figures/iterate_figure.hpp>
#include <isostretch/figures/solid_figure.hpp>

namespace isostretch::comparison {
namespace {

std::string inverted_text(const deformation::StrainField& strain) {
  return strain.inverted.empty()
             ? "none inverted"
             : with_thousands(static_cast<long long>(strain.inverted.size())) + " inverted (blue)";
}

std::string gap_text(const ManipulationFrame& f) {
  if (f.rival) return std::string(f.status());
  return f.certified() ? formatted("certified gap %.1e", f.summary.gap) : "not certified";
}

figures::IterateRow row_of(const sdp_penalty::Iteration& row) {
  return {row.iteration, row.seconds, row.inverted, figures::relative_gap(row.energy, row.lower_bound),
          row.infeasible == 0};
}

}  // namespace

std::string draw_states(const ManipulationReport& r, const deformation::Strain& strain) {
  const ManipulationFrame& f = r.last;
  const deformation::StrainField rest = strain.at(r.body.rest_positions()), before = strain.at(f.before),
                                 after = strain.at(f.positions);
  const auto state = [&](std::string caption, const Vector& positions, const deformation::StrainField& field,
                         std::vector<figures::Marker> markers) {
    return figures::DeformedState{std::move(caption),
                                  figures::surface_points(r.body, r.body.points(positions)),
                                  field.length_change, field.inverted, std::move(markers)};
  };
  return figures::draw_deformation(
      {.title = r.name + formatted(", frame %d of %d", f.frame, r.scene.script.frames) +
                (r.scene.rival.empty() ? "" : ", by " + r.scene.rival),
       .subtitle = with_thousands(r.body.elements.element_count()) + " " +
                   deformation::plural_name(r.body.shape) +
                   formatted("   ·   %d iterations, %.2f s   ·   ", f.summary.iterations, f.seconds) +
                   gap_text(f) + formatted("   ·   min det F %.2g", after.smallest_det()) +
                   "   ·   lines: where handles end, rings: targets",
       .states = {state("at rest", r.body.rest_positions(), rest,
                        figures::rest_markers(r.handle_set, r.body, f.time)),
                  state("unconstrained: " + inverted_text(before), f.before, before, {}),
                  state("result: " + inverted_text(after), f.positions, after,
                        figures::target_markers(r.handle_set, r.body, f.time, f.positions))},
       .triangles = r.body.surface.mesh.triangles,
       .element = r.body.surface.element,
       .volumes = r.body.volumes(),
       .lines = figures::figure_lines(r.handle_set, r.body),
       .flat = r.body.dim == 2,
       .up = r.scene.up});
}

std::string draw_path(const ManipulationReport& r, const deformation::Strain& strain) {
  figures::DeformationFigure figure{
      .title = r.name + formatted(", frame %d: the way there", r.last.frame),
      .subtitle = "Iterates from the unconstrained minimiser to the result; inverted elements blue",
      .states = {},
      .triangles = r.body.surface.mesh.triangles,
      .element = r.body.surface.element,
      .volumes = r.body.volumes(),
      .lines = figures::figure_lines(r.handle_set, r.body),
      .flat = r.body.dim == 2,
      .up = r.scene.up};
  std::vector<figures::IterateRow> shown, trace;
  for (const deformation::Iterate* iterate : r.last.path.selection(figures::shown_iterates)) {
    const deformation::StrainField field = strain.at(iterate->positions);
    figure.states.push_back({{},
                             figures::surface_points(r.body, r.body.points(iterate->positions)),
                             field.length_change,
                             field.inverted});
    shown.push_back(row_of(iterate->row));
  }
  for (const sdp_penalty::Iteration& row : r.last.summary.trace) trace.push_back(row_of(row));
  return figures::draw_iterates(figure, shown, trace);
}

}  // namespace isostretch::comparison
