#include "file.hpp"
#include "output.hpp"
#include "writable.hpp"

#include <isostretch/mesh_io/io.hpp>

namespace isostretch::mesh {

std::string format_off(const SurfaceMesh& mesh) {
  require_writable(mesh);
  std::string text = "OFF\n";
  append(text, mesh.vertices.rows());
  text += ' ';
  append(text, mesh.triangles.rows());
  text += " 0\n";
  append_lines(text, mesh.vertices);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    text += '3';
    append_row(text, mesh.triangles, t);
    text += '\n';
  }
  return text;
}

void write_off(const std::string& path, const SurfaceMesh& mesh) {
  write_file(path, format_off(mesh));
}

}  // namespace isostretch::mesh
