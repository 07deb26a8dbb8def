#include <isostretch/figures/interpolation_figure.hpp>

#include <isostretch/core/text.hpp>
#include <isostretch/deformation/strain.hpp>
#include <isostretch/figures/solid_figure.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::figures {
namespace {

using deformation::SolidModel;

// Frames to draw side by side, evenly over the way.
bool is_drawn(int frame, int frames) {
  constexpr int intervals = 4;
  for (int i = 0; i <= intervals; ++i)
    if (frame == (2 * i * frames + intervals) / (2 * intervals)) return true;
  return false;
}

std::string subtitle(const InterpolationFigure& f) {
  const SolidModel& body = f.key_shapes.first;
  double least = HUGE_VAL;
  for (const InterpolationPoint& point : f.points)
    least = std::min({least, point.min_det_F_1, point.min_det_F_2});
  return with_thousands(body.elements.element_count()) + " " + deformation::plural_name(body.shape) +
         formatted(
             "   ·   %zu frames, %ld iterations   ·   min det F %.3g over all   ·   colour: against the "
             "first pose",
             f.points.size(), f.iterations, least);
}

std::string caption(const InterpolationFigure& f, const Snapshot& shot) {
  if (shot.number == 0) return "first pose";
  if (shot.number == f.frames) return "second pose";
  return formatted("frame %d, t = %.3g", shot.number, shot.time);
}

}  // namespace

void keep_snapshot(std::vector<Snapshot>& snapshots, Snapshot shot, int frames) {
  if (!snapshots.empty() && !is_drawn(snapshots.back().number, frames)) snapshots.pop_back();
  snapshots.push_back(std::move(shot));
}

std::string draw_frames(const InterpolationFigure& f) {
  const SolidModel& body = f.key_shapes.first;
  const deformation::Strain strain(body.elements);
  std::vector<DeformedState> states;
  for (const Snapshot& shot : f.snapshots) {
    deformation::StrainField field = strain.at(shot.positions);
    states.push_back({caption(f, shot), surface_points(body, body.points(shot.positions)),
                      std::move(field.length_change), std::move(field.inverted)});
  }
  return draw_deformation(
      {.title = f.key_shapes.first.name + " to " + f.key_shapes.second.name + ", " + f.energy_name,
       .subtitle = subtitle(f),
       .states = std::move(states),
       .triangles = body.surface.mesh.triangles,
       .element = body.surface.element,
       .volumes = body.volumes(),
       .lines = outline(body),
       .flat = body.dim == 2});
}

}  // namespace isostretch::figures
