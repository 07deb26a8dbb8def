#include <isostretch/parameterization/tutte.hpp>
#include <isostretch/surface/boundary.hpp>

#include <iterator>
#include <vector>

namespace isostretch::parameterization {

mesh::SurfaceMesh fill_holes(const mesh::SurfaceMesh& mesh) {
  std::vector<std::vector<int>> loops = mesh::boundary_loops(mesh);
  mesh::SurfaceMesh filled{mesh.vertices, mesh.triangles, {}, {}};
  if (loops.size() < 2) return filled;
  loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(mesh::longest_loop(mesh, loops)));
  Eigen::Index sides = 0;
  for (const auto& loop : loops) sides += std::ssize(loop);
  Eigen::Index vertex = mesh.vertices.rows(), triangle = mesh.triangles.rows();
  filled.vertices.conservativeResize(vertex + std::ssize(loops), Eigen::NoChange);
  filled.triangles.conservativeResize(triangle + sides, Eigen::NoChange);
  for (const auto& loop : loops) {
    filled.vertices.row(vertex).setZero();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      filled.vertices.row(vertex) += mesh.vertices.row(loop[i]) / static_cast<double>(loop.size());
      // The surface is on the left of the loop, the fan on the right.
      filled.triangles.row(triangle++) << loop[(i + 1) % loop.size()], loop[i], static_cast<int>(vertex);
    }
    ++vertex;
  }
  return filled;
}

}  // namespace isostretch::parameterization
