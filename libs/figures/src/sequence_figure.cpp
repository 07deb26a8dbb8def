#include <isostretch/figures/sequence_figure.hpp>

#include <isostretch/core/text.hpp>
#include <isostretch/figures/solid_figure.hpp>

namespace isostretch::figures {
namespace {

std::string energies_text(const SequenceFigure& f) {
  std::string text;
  for (const deformation::Region& region : f.problem.regions())
    if (text.find(region.energy.name()) == std::string::npos)
      text.append(text.empty() ? "" : ", ").append(region.energy.name());
  return text;
}

std::string subtitle(const SequenceFigure& f, const deformation::StrainField& last) {
  const std::string text = with_thousands(f.body.elements.element_count()) + " " +
                           deformation::plural_name(f.body.shape) +
                           formatted("   ·   %d of %d frames, %ld iterations   ·   min det F %.3g", f.frame,
                                     f.frames, f.iterations, last.smallest_det());
  return text + formatted("   ·   %zu inverted%s   ·   lines: where handles end", last.inverted.size(),
                          last.inverted.empty() ? "" : " (blue)");
}

}  // namespace

std::string draw_sequence(const SequenceFigure& f) {
  const deformation::Strain strain(f.body.elements);
  const deformation::StrainField rest = strain.at(f.body.rest_positions()), last = strain.at(f.positions);
  return draw_deformation(
      {.title = f.body.name + ", " + energies_text(f),
       .subtitle = subtitle(f, last),
       .states = {{"at rest", surface_points(f.body, f.body.nodes), rest.length_change, rest.inverted,
                   rest_markers(f.handle_set, f.body, f.time)},
                  {formatted("frame %d, time %g", f.frame, f.time),
                   surface_points(f.body, f.body.points(f.positions)), last.length_change, last.inverted,
                   target_markers(f.handle_set, f.body, f.time, f.positions)}},
       .triangles = f.body.surface.mesh.triangles,
       .element = f.body.surface.element,
       .volumes = f.body.volumes(),
       .lines = figure_lines(f.handle_set, f.body),
       .flat = f.body.dim == 2});
}

}  // namespace isostretch::figures
