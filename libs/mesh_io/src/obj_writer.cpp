#include "file.hpp"
#include "output.hpp"
#include "writable.hpp"

#include <isostretch/mesh_io/io.hpp>

namespace isostretch::mesh {
namespace {

template <class Points>
void append_points(std::string& text, const char* keyword, const Points& points) {
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    text += keyword;
    append_row(text, points, i);
    text += '\n';
  }
}

void append_faces(std::string& text, const SurfaceMesh& mesh) {
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    text += 'f';
    for (int c = 0; c < 3; ++c) {
      text += ' ';
      append(text, mesh.triangles(t, c) + 1);
      if (!mesh.has_uv()) continue;
      text += '/';
      append(text, mesh.uv_triangles(t, c) + 1);
    }
    text += '\n';
  }
}

}  // namespace

std::string format_obj(const SurfaceMesh& mesh) {
  require_writable(mesh);
  std::string text;
  append_points(text, "v", mesh.vertices);
  if (mesh.has_uv()) append_points(text, "vt", mesh.uv);
  append_faces(text, mesh);
  return text;
}

void write_obj(const std::string& path, const SurfaceMesh& mesh) {
  write_file(path, format_obj(mesh));
}

}  // namespace isostretch::mesh
