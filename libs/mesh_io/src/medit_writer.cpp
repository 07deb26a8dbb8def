#include "file.hpp"
#include "output.hpp"
#include "writable.hpp"

#include <isostretch/mesh_io/io.hpp>

namespace isostretch::mesh {
namespace {

// One row a line, the reference 0 at its end.
template <class Matrix>
void append_section(std::string& text, const char* keyword, const Matrix& matrix, int offset) {
  text += keyword;
  text += '\n';
  append(text, matrix.rows());
  text += '\n';
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    append_row(text, matrix, i, offset);
    text += " 0\n";
  }
}

// Version 2: double precision.
template <class Elements>
std::string format(const Points3& vertices, const char* keyword, const Elements& elements) {
  std::string text = "MeshVersionFormatted 2\nDimension 3\n";
  append_section(text, "Vertices", vertices, 0);
  append_section(text, keyword, elements, 1);
  text += "End\n";
  return text;
}

}  // namespace

std::string format_medit(const SurfaceMesh& mesh) {
  require_writable(mesh);
  return format(mesh.vertices, "Triangles", mesh.triangles);
}

std::string format_medit(const TetMesh& mesh) {
  require_writable(mesh);
  return format(mesh.vertices, "Tetrahedra", mesh.tets);
}

void write_medit(const std::string& path, const SurfaceMesh& mesh) {
  write_file(path, format_medit(mesh));
}

void write_medit(const std::string& path, const TetMesh& mesh) {
  write_file(path, format_medit(mesh));
}

}  // namespace isostretch::mesh
