#include "file.hpp"
#include "output.hpp"
#include "writable.hpp"

#include <isostretch/mesh/io.hpp>

namespace isostretch::mesh {
namespace {

std::string header(const SurfaceMesh& mesh, const char* encoding) {
  std::string text = "ply\nformat ";
  text += encoding;
  text += " 1.0\nelement vertex " + std::to_string(mesh.vertices.rows()) +
          "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
          std::to_string(mesh.triangles.rows()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  return text;
}

void append_text(std::string& out, const SurfaceMesh& mesh) {
  append_lines(out, mesh.vertices);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    out += '3';
    append_row(out, mesh.triangles, t);
    out += '\n';
  }
}

void append_binary(std::string& out, const SurfaceMesh& mesh) {
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) append_row_bytes(out, mesh.vertices, i);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    out += '\3';
    append_row_bytes(out, mesh.triangles, t);
  }
}

}  // namespace

std::string format_ply(const SurfaceMesh& mesh, const WriteOptions& options) {
  require_writable(mesh);
  const bool binary = options.encoding == Encoding::binary;
  std::string out = header(mesh, binary ? "binary_little_endian" : "ascii");
  if (binary)
    append_binary(out, mesh);
  else
    append_text(out, mesh);
  return out;
}

void write_ply(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options) {
  write_file(path, format_ply(mesh, options));
}

}  // namespace isostretch::mesh
