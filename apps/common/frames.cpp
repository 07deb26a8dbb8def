#include "common/frames.hpp"

#include "common/exit_code.hpp"
#include "common/vtu.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/mesh_io/io.hpp>

namespace isostretch::app {
namespace {

mesh::SurfaceMesh surface_at(const SolidModel& body, const mesh::Points3& points) {
  mesh::SurfaceMesh surface;
  surface.triangles = body.surface.mesh.triangles;
  surface.vertices.resize(static_cast<Eigen::Index>(body.surface.original_vertex.size()), 3);
  for (Eigen::Index v = 0; v < surface.vertices.rows(); ++v)
    surface.vertices.row(v) = points.row(body.surface.original_vertex[static_cast<std::size_t>(v)]);
  return surface;
}

mesh::TetMesh tets_at(const SolidModel& body, const mesh::Points3& points) {
  mesh::TetMesh tets{points, {}};
  tets.tets = Eigen::Map<const mesh::Tets>(body.elements.nodes.data(), body.elements.element_count(), 4);
  return tets;
}

}  // namespace

std::string frame_name(int number, FrameFormat format) {
  return formatted("frame_%04d.", number) + name_of(choice_names(format), format);
}

void require_holds(FrameFormat format, const SolidModel& body) {
  if (format == FrameFormat::msh && body.shape != mesh::Shape::tet && body.shape != mesh::Shape::triangle)
    throw Error("format: MSH is written with linear triangles and tets, not with " +
                deformation::plural_name(body.shape) + "; take vtu");
}

std::string format_frame(FrameFormat format, const SolidModel& body, const Vector& positions,
                         const std::vector<CellField>& fields) {
  const mesh::Points3 flat = body.points(positions);
  if (format == FrameFormat::vtu) return vtu_text(body, flat, fields);
  const mesh::Points3 points = body.placed(flat);
  if (format == FrameFormat::obj) return mesh::format_obj(surface_at(body, points));
  return body.dim == 2 ? mesh::format_msh(surface_at(body, points)) : mesh::format_msh(tets_at(body, points));
}

std::string pvd_text(const std::vector<std::pair<std::string, double>>& file_and_time) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (const auto& [file, time] : file_and_time)
    text += "<DataSet timestep=\"" + to_text(time) + "\" file=\"" + file + "\"/>\n";
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace isostretch::app
