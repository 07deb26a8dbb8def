#include "common/figures/deformation_figure.hpp"
#include "common/figures/edges.hpp"
#include "common/formatted.hpp"
#include "report.hpp"

#include <algorithm>

namespace isostretch::app::deform {
namespace {

mesh::Points3 surface_points(const Body& body, const mesh::Points3& points) {
  mesh::Points3 result(static_cast<Eigen::Index>(body.surface.original_vertex.size()), 3);
  for (Eigen::Index v = 0; v < result.rows(); ++v)
    result.row(v) = points.row(body.surface.original_vertex[static_cast<std::size_t>(v)]);
  return result;
}

// Edges of the surface along which a handle ends: both ends are its own, and a neighbour's third vertex is
// not.
std::vector<std::array<int, 2>> handle_outlines(const Result& r) {
  std::vector<int> owner(static_cast<std::size_t>(r.body.nodes.rows()), -1);
  for (std::size_t h = 0; h < r.rig.handles().size(); ++h)
    for (const int node : r.rig.handles()[h].nodes)
      owner[static_cast<std::size_t>(node)] = static_cast<int>(h);
  const auto& surface = r.body.surface;
  const auto owner_of = [&](int vertex) {
    return owner[static_cast<std::size_t>(surface.original_vertex[static_cast<std::size_t>(vertex)])];
  };
  std::vector<std::array<int, 2>> lines;
  for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c) {
      const int a = surface.mesh.triangles(t, c), b = surface.mesh.triangles(t, (c + 1) % 3),
                opposite = surface.mesh.triangles(t, (c + 2) % 3);
      if (owner_of(a) >= 0 && owner_of(a) == owner_of(b) && owner_of(opposite) != owner_of(a))
        lines.push_back({a, b});
    }
  return lines;
}

std::string energies_text(const Result& r) {
  std::string text;
  for (const Region& region : r.problem.regions())
    if (text.find(region.energy.name()) == std::string::npos)
      text.append(text.empty() ? "" : ", ").append(region.energy.name());
  return text;
}

std::string subtitle(const Result& r) {
  const Json& last = r.frames.back();
  long iterations = 0;
  for (const Json& frame : r.frames) iterations += frame.value("iterations", 0);
  std::string text =
      with_thousands(r.body.elements.element_count()) + " " + plural_name(r.body.shape) +
      formatted("   ·   %d of %d frames, %ld iterations   ·   min det F %.3g", last["frame"].get<int>(),
                r.scene.frames, iterations, last["min_det_F"].get<double>());
  const int inverted = last["inverted"].get<int>();
  return text + formatted("   ·   %d inverted%s   ·   lines: where handles end", inverted,
                          inverted > 0 ? " (blue)" : "");
}

}  // namespace

std::string draw(const Result& r, const Strain& strain) {
  const StrainField rest = strain.at(r.body.rest_positions()), last = strain.at(r.positions);
  const int number = r.frames.back()["frame"].get<int>();
  std::vector<std::array<int, 2>> lines = handle_outlines(r);
  if (r.body.dim == 2) {
    const auto outline = figures::edges_of(r.body.surface.mesh.triangles).boundary;
    lines.insert(lines.end(), outline.begin(), outline.end());
  }
  return figures::draw_deformation(
      {.title = r.body.name + ", " + energies_text(r),
       .subtitle = subtitle(r),
       .states = {{"at rest", surface_points(r.body, r.body.nodes), rest.length_change, rest.inverted},
                  {formatted("frame %d, time %g", number, r.frames.back()["time"].get<double>()),
                   surface_points(r.body, r.body.points(r.positions)), last.length_change, last.inverted}},
       .triangles = r.body.surface.mesh.triangles,
       .element = r.body.surface.element,
       .volumes = r.body.volumes(),
       .lines = std::move(lines),
       .flat = r.body.dim == 2});
}

}  // namespace isostretch::app::deform
