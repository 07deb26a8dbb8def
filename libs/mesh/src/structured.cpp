
#include <isostretch/core/to_text.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/require.hpp>
#include <isostretch/mesh/structured.hpp>

#include <cmath>
#include <limits>
#include <string>

namespace isostretch::mesh {
namespace {

void require_layers(const QuadMesh& mesh, int layers, double height) {
  if (layers < 1) throw Error("layers is " + std::to_string(layers) + ", must be at least 1");
  if (!(height > 0 && std::isfinite(height)))
    throw Error("height is " + isostretch::to_text(height) + ", must be positive");
  constexpr double most = std::numeric_limits<int>::max();
  if (8.0 * double(mesh.quads.rows()) * layers > most ||
      double(mesh.vertices.rows()) * (double(layers) + 1) > most)
    throw Error("the mesh asked for has too many elements");
}

}  // namespace

QuadMesh quad_grid(int nx, int ny, double width, double height) {
  const SurfaceMesh halves = grid(nx, ny, width, height);
  QuadMesh mesh;
  mesh.vertices = halves.vertices.leftCols<2>();
  mesh.quads.resize(halves.triangles.rows() / 2, 4);
  for (Eigen::Index q = 0; q < mesh.quads.rows(); ++q)
    mesh.quads.row(q) << halves.triangles.row(2 * q), halves.triangles(2 * q + 1, 2);
  return mesh;
}

HexMesh extrude(const QuadMesh& mesh, int layers, double height) {
  require_indices(mesh.quads, mesh.vertices.rows(), "quad");
  require_layers(mesh, layers, height);
  const Eigen::Index V = mesh.vertices.rows(), Q = mesh.quads.rows();
  HexMesh result;
  result.vertices.resize(V * (layers + 1), 3);
  for (int k = 0; k <= layers; ++k) {
    result.vertices.middleRows(k * V, V).leftCols<2>() = mesh.vertices;
    result.vertices.middleRows(k * V, V).col(2).setConstant(height * k / layers);
  }
  result.hexes.resize(Q * layers, 8);
  for (int k = 0; k < layers; ++k)
    for (int end = 0; end < 2; ++end)
      result.hexes.middleRows(k * Q, Q).middleCols<4>(4 * end) =
          mesh.quads.array() + static_cast<int>((k + end) * V);
  return result;
}

HexMesh hex_bar(int nx, int ny, int nz, double size_x, double size_y, double size_z) {
  return extrude(quad_grid(nx, ny, size_x, size_y), nz, size_z);
}

}  // namespace isostretch::mesh
