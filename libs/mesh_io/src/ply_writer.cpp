#include "file.hpp"
#include "output.hpp"
#include "writable.hpp"

#include <isostretch/mesh_io/io.hpp>

#include <utility>
#include <vector>

namespace isostretch::mesh {
namespace {

// Texture coordinates of every vertex, where it has the same in all its triangles; empty otherwise, or
// without any.
Points2 uv_of_vertices(const SurfaceMesh& mesh) {
  Points2 uv;
  if (!mesh.has_uv()) return uv;
  uv = Points2::Zero(mesh.vertices.rows(), 2);
  std::vector<char> seen(static_cast<std::size_t>(mesh.vertices.rows()), 0);
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i) {
    const int v = mesh.triangles.data()[i];
    const auto own = mesh.uv.row(mesh.uv_triangles.data()[i]);
    char& known = seen[static_cast<std::size_t>(v)];
    if (known && uv.row(v) != own) return {};
    uv.row(v) = own;
    known = 1;
  }
  return uv;
}

class PlyWriter {
 public:
  PlyWriter(const SurfaceMesh& mesh, bool binary)
      : mesh_(mesh),
        binary_(binary),
        uv_(uv_of_vertices(mesh)),
        uv_in_faces_(mesh.has_uv() && uv_.rows() == 0) {}

  std::string write() {
    header();
    for (Eigen::Index i = 0; i < mesh_.vertices.rows(); ++i) vertex(i);
    for (Eigen::Index t = 0; t < mesh_.triangles.rows(); ++t) face(t);
    return std::move(out_);
  }

 private:
  void header() {
    out_ = std::string("ply\nformat ") + (binary_ ? "binary_little_endian" : "ascii") +
           " 1.0\nelement vertex " + std::to_string(mesh_.vertices.rows()) +
           "\nproperty double x\nproperty double y\nproperty double z\n";
    if (uv_.rows() > 0) out_ += "property double s\nproperty double t\n";
    out_ += "element face " + std::to_string(mesh_.triangles.rows()) +
            "\nproperty list uchar int vertex_indices\n";
    if (uv_in_faces_) out_ += "property list uchar double texcoord\n";
    out_ += "end_header\n";
  }

  void vertex(Eigen::Index i) {
    row(mesh_.vertices, i);
    if (uv_.rows() > 0) row(uv_, i);
    end();
  }

  void face(Eigen::Index t) {
    length(3);
    row(mesh_.triangles, t);
    if (uv_in_faces_) {
      length(6);
      for (int c = 0; c < 3; ++c) row(mesh_.uv, mesh_.uv_triangles(t, c));
    }
    end();
  }

  void length(char count) {
    binary_ ? void(out_ += count) : void(out_.append(" ") += static_cast<char>('0' + count));
  }
  template <class Matrix>
  void row(const Matrix& matrix, Eigen::Index i) {
    binary_ ? append_row_bytes(out_, matrix, i) : append_row(out_, matrix, i);
  }
  void end() {
    if (!binary_) out_ += '\n';
  }

  const SurfaceMesh& mesh_;
  bool binary_;
  Points2 uv_;
  bool uv_in_faces_;
  std::string out_;
};

}  // namespace

std::string format_ply(const SurfaceMesh& mesh, const WriteOptions& options) {
  require_writable(mesh);
  return PlyWriter(mesh, options.encoding == Encoding::binary).write();
}

void write_ply(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options) {
  write_file(path, format_ply(mesh, options));
}

}  // namespace isostretch::mesh
