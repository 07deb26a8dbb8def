#include "writable.hpp"

#include <isostretch/mesh/require.hpp>

#include <limits>

namespace isostretch::mesh {
namespace {

// Formats number elements with 32 bits.
void require_count(Eigen::Index count, const char* what) {
  if (count == 0) throw Error(std::string("the mesh has no ") + what);
  if (count > std::numeric_limits<int>::max())
    throw Error("the mesh has " + std::to_string(count) + " " + what + ", too many to write");
}

}  // namespace

void require_writable(const SurfaceMesh& mesh) {
  require_count(mesh.triangles.rows(), "triangles");
  require_consistent(mesh);
}

void require_writable(const TetMesh& mesh) {
  require_count(mesh.tets.rows(), "tetrahedra");
  require_finite(mesh.vertices, "vertex");
  require_indices(mesh.tets, mesh.vertices.rows(), "tet");
}

void require_writable(const ElementMesh& mesh) {
  require_count(mesh.elements.rows(), "elements");
  require_finite(mesh.vertices, "vertex");
  if (mesh.elements.cols() != shape_node_count(mesh.shape))
    throw Error("elements: " + std::to_string(mesh.elements.cols()) + " vertices each, and the shape has " +
                std::to_string(shape_node_count(mesh.shape)));
  require_indices(mesh.elements, mesh.vertices.rows(), "element");
}

}  // namespace isostretch::mesh
