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
  require_finite(mesh.vertices, "vertex");
  require_indices(mesh.triangles, mesh.vertices.rows(), "triangle");
  if (!mesh.has_uv()) return;
  if (mesh.uv_triangles.rows() != mesh.triangles.rows())
    throw Error(std::to_string(mesh.uv_triangles.rows()) + " uv triangles for " +
                std::to_string(mesh.triangles.rows()) + " triangles");
  require_finite(mesh.uv, "uv point");
  require_indices(mesh.uv_triangles, mesh.uv.rows(), "uv triangle");
}

void require_writable(const TetMesh& mesh) {
  require_count(mesh.tets.rows(), "tetrahedra");
  require_finite(mesh.vertices, "vertex");
  require_indices(mesh.tets, mesh.vertices.rows(), "tet");
}

}  // namespace isostretch::mesh
