#include "require.hpp"

#include <isostretch/core/atomic_file.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/mesh/io.hpp>

#include <charconv>

namespace isostretch::mesh {
namespace {

template <class Number>
void append(std::string& text, Number value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  text.append(buffer, result.ptr);
}

template <class Points>
void append_points(std::string& text, const char* keyword, const Points& points) {
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    text += keyword;
    for (Eigen::Index c = 0; c < points.cols(); ++c) {
      text += ' ';
      append(text, points(i, c));
    }
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

void require_writable(const SurfaceMesh& mesh) {
  require_finite(mesh.vertices, "vertex");
  require_indices(mesh.triangles, mesh.vertices.rows(), "triangle");
  if (!mesh.has_uv()) return;
  if (mesh.uv_triangles.rows() != mesh.triangles.rows())
    throw Error(std::to_string(mesh.uv_triangles.rows()) + " uv triangles for " +
                std::to_string(mesh.triangles.rows()) + " triangles");
  require_finite(mesh.uv, "uv point");
  require_indices(mesh.uv_triangles, mesh.uv.rows(), "uv triangle");
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
  const std::string text = format_obj(mesh);
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace isostretch::mesh
