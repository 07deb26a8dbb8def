#include "findings.hpp"
#include "measure.hpp"

namespace isostretch::mesh {
namespace {

bool measurable(const TetMesh& mesh, const int* v) {
  for (int i = 0; i < 4; ++i) {
    if (!mesh.vertices.row(v[i]).allFinite()) return false;
    for (int j = 0; j < i; ++j)
      if (v[i] == v[j]) return false;
  }
  return true;
}

}  // namespace

Report check(const TetMesh& mesh, int max_per_kind) {
  Report report;
  Findings findings(report, max_per_kind);
  check_elements("tet", mesh.vertices, mesh.tets, report, findings);
  for (Eigen::Index t = 0; report.indices_valid && t < mesh.tets.rows(); ++t) {
    const int* v = mesh.tets.data() + 4 * t;
    if (!measurable(mesh, v)) continue;
    const TetShape shape = tet_shape(mesh.vertices, v);
    if (shape.degenerate())
      findings.add_element(Kind::zero_size, "tet", mesh.tets, t, "has zero volume");
    else if (shape.six_volumes < 0)
      findings.add_element(Kind::inverted, "tet", mesh.tets, t, "is inverted (negative volume)");
  }
  findings.sort();
  return report;
}

}  // namespace isostretch::mesh
