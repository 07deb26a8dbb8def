
#include <isostretch/mesh/require.hpp>
#include <isostretch/mesh/weld.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace isostretch::mesh {
namespace {

template <class Elements>
WeldedPoints weld_vertices(Points3& vertices, Elements& elements, double tolerance) {
  if (!(tolerance >= 0) || !std::isfinite(tolerance))
    throw Error("the welding tolerance is negative or not finite");
  require_finite(vertices, "vertex");
  require_indices(elements, vertices.rows(), "element");
  const WeldedPoints welded =
      weld(std::vector<double>(vertices.data(), vertices.data() + vertices.size()), tolerance);
  vertices =
      Eigen::Map<const Points3>(welded.points.data(), static_cast<Eigen::Index>(welded.points.size()) / 3, 3);
  for (Eigen::Index i = 0; i < elements.size(); ++i)
    elements.data()[i] = welded.index[static_cast<std::size_t>(elements.data()[i])];
  return welded;
}

}  // namespace

int weld(SurfaceMesh& mesh, double tolerance) {
  const auto before = mesh.vertices.rows();
  weld_vertices(mesh.vertices, mesh.triangles, tolerance);
  return static_cast<int>(before - mesh.vertices.rows());
}

int weld(ElementMesh& mesh, double tolerance) {
  const auto before = mesh.vertices.rows();
  const WeldedPoints welded = weld_vertices(mesh.vertices, mesh.elements, tolerance);
  for (ElementGroup& group : mesh.groups) {
    for (int& v : group.vertices) v = welded.index[static_cast<std::size_t>(v)];
    std::sort(group.vertices.begin(), group.vertices.end());
    group.vertices.erase(std::unique(group.vertices.begin(), group.vertices.end()), group.vertices.end());
  }
  return static_cast<int>(before - mesh.vertices.rows());
}

}  // namespace isostretch::mesh
