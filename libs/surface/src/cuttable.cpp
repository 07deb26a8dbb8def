#include "cuttable.hpp"

#include "generic_weights.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/measure.hpp>
#include <isostretch/surface/check.hpp>

#include <initializer_list>
#include <string>

namespace isostretch::mesh {

void require_cuttable(const SurfaceMesh& mesh) {
  const MeshDiagnostics diagnostics = check(mesh, 1);
  for (const DefectKind kind :
       {DefectKind::index_out_of_range, DefectKind::not_finite, DefectKind::degenerate,
        DefectKind::duplicate_element, DefectKind::non_manifold_edge, DefectKind::non_manifold_vertex,
        DefectKind::not_orientable, DefectKind::inconsistent_orientation})
    if (const Defect* defect = diagnostics.find(kind))
      throw Error("cannot cut the mesh open: " + defect->text);
  if (mesh.triangles.rows() == 0) throw Error("cannot cut the mesh open: it has no triangles");
}

Piece make_piece(const SurfaceMesh& mesh) {
  const auto V = static_cast<int>(mesh.vertices.rows());
  const auto F = static_cast<int>(mesh.triangles.rows());
  Piece piece;
  piece.surface = half_edges(mesh.triangles, V);
  piece.weights = generic_weights(piece.surface, mesh.vertices);
  piece.loops = boundary_half_edges(piece.surface);
  int sides = 3 * F;  // of edges: a boundary edge has one, others have two
  for (const std::vector<int>& loop : piece.loops) {
    double length = 0;
    for (const int h : loop) length += piece.weights[static_cast<std::size_t>(h)];
    piece.loop_lengths.push_back(length);
    sides += static_cast<int>(loop.size());
  }
  piece.extreme = extreme_vertex(mesh.vertices);
  piece.genus = (2 - static_cast<int>(piece.loops.size()) - (V - sides / 2 + F)) / 2;
  for (int t = 0; t < F; ++t)
    piece.area += triangle_shape(mesh.vertices, mesh.triangles.data() + 3 * t).area();
  return piece;
}

}  // namespace isostretch::mesh
