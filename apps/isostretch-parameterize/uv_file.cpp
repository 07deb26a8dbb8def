#include "uv_file.hpp"

#include "common/terminal.hpp"

#include <isostretch/mesh_io/io.hpp>

namespace isostretch::app::parameterize {
namespace {

// Of the triangles of the document, rows of -1 for those that were removed.
mesh::Triangles document_corners(const Input& input, const parameterization::Parameterization& result) {
  const mesh::Triangles& open = result.domain.open().triangles;
  const std::vector<int>& original = input.repairs.original_triangle;
  if (original.empty()) return open;
  mesh::Triangles corners = mesh::Triangles::Constant(input.document->mesh().triangles.rows(), 3, -1);
  for (std::size_t t = 0; t < original.size(); ++t)
    corners.row(original[t]) = open.row(static_cast<Eigen::Index>(t));
  return corners;
}

void tell(const mesh::ObjText& out) {
  if (out.divided_faces > 0)
    notice(std::to_string(out.divided_faces) +
           " face(s) are written as triangles: the cut runs through them");
  if (out.removed_faces > 0)
    notice(std::to_string(out.removed_faces) + " face(s) are left out of the OBJ file");
  if (out.lines_without_uv > 0)
    notice(std::to_string(out.lines_without_uv) + " line(s) of the OBJ file lose their texture coordinates");
  if (out.names_materials)
    notice("the OBJ file names its materials as the model does (mtllib); their files are not copied");
}

}  // namespace

std::string uv_file(const Input& input, const parameterization::Parameterization& result) {
  if (!input.document) return mesh::format_obj(result.textured());
  if (!input.repairs.turned.empty() || !input.repairs.split_vertices.empty()) {
    notice(
        "the OBJ file has the repaired triangles alone: groups, materials, normals and polygons are not "
        "kept");
    return mesh::format_obj(result.textured());
  }
  const mesh::ObjText out = input.document->with_uv(result.layout.uv, document_corners(input, result));
  tell(out);
  return out.text;
}

}  // namespace isostretch::app::parameterize
