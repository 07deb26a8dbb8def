// A file format of one's own, known by its extension wherever meshes are read and written.
#include "expect.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/format.hpp>

#include <fstream>
#include <string>

using namespace isostretch;

// Numbers of vertices and triangles, then rows of both.
mesh::SurfaceMesh read_plain(const std::string& path, const mesh::ReadOptions&) {
  std::ifstream in(path);
  Eigen::Index vertices = 0, triangles = 0;
  if (!(in >> vertices >> triangles)) throw Error(path + ": there are no two numbers at the start");
  mesh::SurfaceMesh mesh;
  mesh.vertices.resize(vertices, 3);
  mesh.triangles.resize(triangles, 3);
  for (Eigen::Index i = 0; i < mesh.vertices.size(); ++i) in >> mesh.vertices.data()[i];
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i) in >> mesh.triangles.data()[i];
  if (!in) throw Error(path + ": ends early");
  return mesh;
}

void write_plain(const std::string& path, const mesh::SurfaceMesh& mesh, const mesh::WriteOptions&) {
  std::ofstream out(path);
  out.precision(17);
  out << mesh.vertices.rows() << ' ' << mesh.triangles.rows() << '\n';
  for (Eigen::Index i = 0; i < mesh.vertices.size(); ++i) out << mesh.vertices.data()[i] << '\n';
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i) out << mesh.triangles.data()[i] << '\n';
}

int main() {
  mesh::register_format({.extension = ".plain", .read_surface = read_plain, .write_surface = write_plain});
  const mesh::SurfaceMesh sphere = mesh::icosphere(2);
  mesh::write_surface("sphere.plain", sphere);
  const mesh::SurfaceMesh again = mesh::read_surface("sphere.plain");
  EXPECT(again.vertices == sphere.vertices && again.triangles == sphere.triangles);
  EXPECT(mesh::read_elements("sphere.plain").elements.rows() == sphere.triangles.rows());
}
