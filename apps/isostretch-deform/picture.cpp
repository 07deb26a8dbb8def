#include "common/rig_figure.hpp"
#include "report.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/figures/deformation_figure.hpp>

namespace isostretch::app::deform {
namespace {

std::string energies_text(const Result& r) {
  std::string text;
  for (const deformation::Region& region : r.problem.regions())
    if (text.find(region.energy.name()) == std::string::npos)
      text.append(text.empty() ? "" : ", ").append(region.energy.name());
  return text;
}

std::string subtitle(const Result& r) {
  const Json& last = r.frames.back();
  long iterations = 0;
  for (const Json& frame : r.frames) iterations += frame.value("iterations", 0);
  std::string text =
      with_thousands(r.body.elements.element_count()) + " " + deformation::plural_name(r.body.shape) +
      formatted("   ·   %d of %d frames, %ld iterations   ·   min det F %.3g", last["frame"].get<int>(),
                r.scene.script.frames, iterations, last["min_det_F"].get<double>());
  const int inverted = last["inverted"].get<int>();
  return text + formatted("   ·   %d inverted%s   ·   lines: where handles end", inverted,
                          inverted > 0 ? " (blue)" : "");
}

}  // namespace

std::string draw(const Result& r, const Strain& strain) {
  const StrainField rest = strain.at(r.body.rest_positions()), last = strain.at(r.positions);
  const int number = r.frames.back()["frame"].get<int>();
  const double time = r.frames.back()["time"].get<double>();
  return figures::draw_deformation(
      {.title = r.body.name + ", " + energies_text(r),
       .subtitle = subtitle(r),
       .states = {{"at rest", surface_points(r.body, r.body.nodes), rest.length_change, rest.inverted,
                   rest_markers(r.handle_set, r.body, time)},
                  {formatted("frame %d, time %g", number, time),
                   surface_points(r.body, r.body.points(r.positions)), last.length_change, last.inverted,
                   target_markers(r.handle_set, r.body, time, r.positions)}},
       .triangles = r.body.surface.mesh.triangles,
       .element = r.body.surface.element,
       .volumes = r.body.volumes(),
       .lines = figure_lines(r.handle_set, r.body),
       .flat = r.body.dim == 2});
}

}  // namespace isostretch::app::deform
