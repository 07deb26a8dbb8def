#include "io/weld.hpp"
#include "require.hpp"

#include <isostretch/mesh/weld.hpp>

#include <cmath>
#include <vector>

namespace isostretch::mesh {
namespace {

template <class Elements>
int weld_vertices(Points3& vertices, Elements& elements, double tolerance) {
  if (!(tolerance >= 0) || !std::isfinite(tolerance))
    throw Error("the welding tolerance is negative or not finite");
  require_finite(vertices, "vertex");
  require_indices(elements, vertices.rows(), "element");
  const Welded welded =
      weld(std::vector<double>(vertices.data(), vertices.data() + vertices.size()), tolerance);
  const auto before = static_cast<int>(vertices.rows());
  vertices =
      Eigen::Map<const Points3>(welded.points.data(), static_cast<Eigen::Index>(welded.points.size()) / 3, 3);
  for (Eigen::Index i = 0; i < elements.size(); ++i)
    elements.data()[i] = welded.index[static_cast<std::size_t>(elements.data()[i])];
  return before - static_cast<int>(vertices.rows());
}

}  // namespace

int weld(SurfaceMesh& mesh, double tolerance) {
  return weld_vertices(mesh.vertices, mesh.triangles, tolerance);
}

int weld(ElementMesh& mesh, double tolerance) {
  return weld_vertices(mesh.vertices, mesh.elements, tolerance);
}

}  // namespace isostretch::mesh
