#include "report.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/figures/deformation_figure.hpp>
#include <isostretch/surface/edges.hpp>

namespace isostretch::app::interpolate {
namespace {

mesh::Points3 surface_points(const SolidModel& body, const Vector& positions) {
  const mesh::Points3 points = body.points(positions);
  const std::vector<int>& original = body.surface.original_vertex;
  mesh::Points3 result(static_cast<Eigen::Index>(original.size()), 3);
  for (Eigen::Index v = 0; v < result.rows(); ++v)
    result.row(v) = points.row(original[static_cast<std::size_t>(v)]);
  return result;
}

std::string subtitle(const Result& r) {
  const SolidModel& body = r.poses.first;
  double least = HUGE_VAL;
  long iterations = 0;
  for (const Json& frame : r.frames) {
    least = std::min({least, frame["min_det_F_1"].get<double>(), frame["min_det_F_2"].get<double>()});
    iterations += frame["iterations"].get<long>();
  }
  return with_thousands(body.elements.element_count()) + " " + deformation::plural_name(body.shape) +
         formatted(
             "   ·   %zu frames, %ld iterations   ·   min det F %.3g over all   ·   colour: against the "
             "first pose",
             r.frames.size(), iterations, least);
}

std::string caption(const Result& r, const Snapshot& shot) {
  if (shot.number == 0) return "first pose";
  if (shot.number == r.options.frames) return "second pose";
  return formatted("frame %d, t = %.3g", shot.number, shot.time);
}

}  // namespace

std::string draw_frames(const Result& r) {
  const SolidModel& body = r.poses.first;
  const Strain strain(body.elements);
  std::vector<figures::DeformedState> states;
  for (const Snapshot& shot : r.snapshots) {
    StrainField field = strain.at(shot.positions);
    states.push_back({caption(r, shot), surface_points(body, shot.positions), std::move(field.length_change),
                      std::move(field.inverted)});
  }
  std::vector<std::array<int, 2>> lines;
  if (body.dim == 2) lines = mesh::edges_of(body.surface.mesh.triangles).boundary;
  return figures::draw_deformation(
      {.title = r.poses.first.name + " to " + r.poses.second.name + ", " + r.energy.name(),
       .subtitle = subtitle(r),
       .states = std::move(states),
       .triangles = body.surface.mesh.triangles,
       .element = body.surface.element,
       .volumes = body.volumes(),
       .lines = std::move(lines),
       .flat = body.dim == 2});
}

}  // namespace isostretch::app::interpolate
