#include <isostretch/deformation/frame_file.hpp>

#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>

#include <algorithm>

namespace isostretch::deformation {
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

// Points are where the file has the body, which a flat one may have in any plane.
std::string vtu_text(const SolidModel& body, const mesh::Points3& flat,
                     const std::vector<mesh::MeshField>& fields,
                     const std::vector<mesh::MeshField>& node_fields) {
  mesh::ElementMesh elements{body.shape, body.placed(flat), {}, {}};
  elements.elements.resize(body.elements.element_count(), body.elements.nodes_per_element);
  std::copy(body.elements.nodes.begin(), body.elements.nodes.end(), elements.elements.data());
  const mesh::Points3 displacement = elements.vertices - body.placed(body.nodes);
  std::vector<mesh::MeshField> at_vertices{
      {"displacement", {displacement.data(), displacement.data() + displacement.size()}, 3}};
  at_vertices.insert(at_vertices.end(), node_fields.begin(), node_fields.end());
  return mesh::format_vtu(elements, at_vertices, fields);
}

}  // namespace

std::string frame_name(int number, FrameFormat format) {
  return formatted("frame_%04d.", number) + name_of(choice_names(format), format);
}

void require_holds(FrameFormat format, const SolidModel& body) {
  if (format == FrameFormat::msh && body.shape != mesh::Shape::tet && body.shape != mesh::Shape::triangle)
    throw Error("format: MSH is written with linear triangles and tets, not with " + plural_name(body.shape) +
                "; take vtu");
}

std::string format_frame(FrameFormat format, const SolidModel& body, const Vector& positions,
                         const std::vector<mesh::MeshField>& fields) {
  const mesh::Points3 flat = body.points(positions);
  if (format == FrameFormat::vtu) return vtu_text(body, flat, fields, {});
  const mesh::Points3 points = body.placed(flat);
  if (format == FrameFormat::obj) return mesh::format_obj(surface_at(body, points));
  return body.dim == 2 ? mesh::format_msh(surface_at(body, points)) : mesh::format_msh(tets_at(body, points));
}

std::string format_rest(const SolidModel& body, const std::vector<mesh::MeshField>& node_fields) {
  return vtu_text(body, body.nodes, {}, node_fields);
}

std::vector<mesh::MeshField> weight_fields(const handles::HandleWeights& weights) {
  std::vector<mesh::MeshField> fields;
  const auto count = static_cast<std::size_t>(weights.handles);
  for (std::size_t h = 0; h < count; ++h) {
    fields.push_back({"weight_" + std::to_string(h), {}});
    for (std::size_t i = h; i < weights.values.size(); i += count)
      fields.back().values.push_back(weights.values[i]);
  }
  return fields;
}

std::string pvd_text(const std::vector<std::pair<std::string, double>>& file_and_time) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (const auto& [file, time] : file_and_time)
    text += "<DataSet timestep=\"" + to_text(time) + "\" file=\"" + file + "\"/>\n";
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace isostretch::deformation
