#include "defects.hpp"

#include <isostretch/mesh/measure.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace isostretch::mesh {
namespace {

bool has_distinct_vertices(const int* v) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j)
      if (v[i] == v[j]) return false;
  return true;
}

bool measurable(const TetMesh& mesh, const int* v) {
  for (int i = 0; i < 4; ++i)
    if (!mesh.vertices.row(v[i]).allFinite()) return false;
  return has_distinct_vertices(v);
}

// A face of a tet, its vertices ordered.
struct Face {
  std::array<int, 3> vertices;
  int tet;
  bool odd;  // seen from outside the tet they run clockwise

  std::string text() const {
    return "face " + std::to_string(vertices[0]) + "-" + std::to_string(vertices[1]) + "-" +
           std::to_string(vertices[2]);
  }
};

Face face(const Tets& tets, Eigen::Index t, int opposite) {
  // Counter-clockwise seen from outside.
  static constexpr int corners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  Face result{{}, static_cast<int>(t), false};
  std::array<int, 3>& v = result.vertices;
  for (int i = 0; i < 3; ++i) v[static_cast<std::size_t>(i)] = tets(t, corners[opposite][i]);
  for (const auto& [i, j] : {std::pair(0U, 1U), std::pair(1U, 2U), std::pair(0U, 1U)})
    if (v[i] > v[j]) {
      std::swap(v[i], v[j]);
      result.odd = !result.odd;
    }
  return result;
}

std::vector<Face> sorted_faces(const Tets& tets) {
  std::vector<Face> faces;
  for (Eigen::Index t = 0; t < tets.rows(); ++t)
    for (int opposite = 0; opposite < 4 && has_distinct_vertices(tets.data() + 4 * t); ++opposite)
      faces.push_back(face(tets, t, opposite));
  std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
    return std::tie(a.vertices, a.tet) < std::tie(b.vertices, b.tet);
  });
  return faces;
}

void check_face(const Face* begin, const Face* end, DefectCollector& defects) {
  std::vector<int> tets;
  for (const Face* each = begin; each < end; ++each) tets.push_back(each->tet);
  const std::vector<int> vertices(begin->vertices.begin(), begin->vertices.end());
  if (tets.size() > 2) {
    defects.add(DefectKind::non_manifold_face, tets, vertices, [&] {
      std::string list;
      for (const int tet : tets) list += (list.empty() ? "" : ", ") + std::to_string(tet);
      return begin->text() + " belongs to " + std::to_string(tets.size()) + " tets: " + list;
    });
  } else if (tets.size() == 2 && begin[0].odd == begin[1].odd) {
    defects.add(DefectKind::inconsistent_orientation, tets, vertices, [&] {
      return "tets " + std::to_string(tets[0]) + " and " + std::to_string(tets[1]) +
             " are oriented against each other at " + begin->text();
    });
  }
}

void check_faces(const Tets& tets, DefectCollector& defects) {
  const std::vector<Face> faces = sorted_faces(tets);
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
    while (end < faces.size() && faces[end].vertices == faces[begin].vertices) ++end;
    check_face(faces.data() + begin, faces.data() + end, defects);
  }
}

}  // namespace

MeshDiagnostics check(const TetMesh& mesh, int max_per_kind) {
  MeshDiagnostics diagnostics;
  DefectCollector defects(diagnostics, max_per_kind);
  check_elements("tet", mesh.vertices, mesh.tets, diagnostics, defects);
  for (Eigen::Index t = 0; diagnostics.indices_valid && t < mesh.tets.rows(); ++t) {
    const int* v = mesh.tets.data() + 4 * t;
    if (!measurable(mesh, v)) continue;
    const TetShape shape = tet_shape(mesh.vertices, v);
    if (shape.degenerate())
      defects.add_element(DefectKind::zero_size, "tet", mesh.tets, t, "has zero volume");
    else if (shape.six_volumes < 0)
      defects.add_element(DefectKind::inverted, "tet", mesh.tets, t, "is inverted (negative volume)");
  }
  if (diagnostics.indices_valid) check_faces(mesh.tets, defects);
  defects.sort();
  return diagnostics;
}

}  // namespace isostretch::mesh
