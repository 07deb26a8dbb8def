
#include <isostretch/mesh/require.hpp>
#include <isostretch/surface/boundary_surface.hpp>

#include <algorithm>
#include <array>

namespace isostretch::mesh {
namespace {

// Corners of a face by which its two elements recognise it, and the triangles it is drawn with, as positions
// among the nodes of an element, counter-clockwise seen from outside.
struct Face {
  std::vector<int> corners;
  std::vector<std::array<int, 3>> triangles;
};

const std::vector<Face>& tet_faces() {
  static const std::vector<Face> faces = {
      {{0, 2, 1}, {{0, 2, 1}}}, {{0, 1, 3}, {{0, 1, 3}}}, {{1, 2, 3}, {{1, 2, 3}}}, {{0, 3, 2}, {{0, 3, 2}}}};
  return faces;
}

const std::vector<Face>& hex_faces() {
  static const std::vector<Face> faces = [] {
    std::vector<Face> result;
    for (const std::array<int, 4>& q :
         {std::array{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
      result.push_back({{q.begin(), q.end()}, {{q[0], q[1], q[2]}, {q[0], q[2], q[3]}}});
    return result;
  }();
  return faces;
}

// The node in the middle of an edge of a quadratic tet.
int middle(int a, int b) {
  static constexpr int node[4][4] = {{-1, 4, 6, 7}, {4, -1, 5, 8}, {6, 5, -1, 9}, {7, 8, 9, -1}};
  return node[a][b];
}

const std::vector<Face>& quadratic_tet_faces() {
  static const std::vector<Face> faces = [] {
    std::vector<Face> result;
    for (const Face& face : tet_faces()) {
      const int a = face.corners[0], b = face.corners[1], c = face.corners[2];
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      result.push_back({face.corners, {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}});
    }
    return result;
  }();
  return faces;
}

using Key = std::array<int, 4>;  // corners ascending; a triangle's last is -1

template <class Elements>
Key key_of(const Elements& elements, Eigen::Index e, const Face& face) {
  Key key{-1, -1, -1, -1};
  for (std::size_t c = 0; c < face.corners.size(); ++c) key[c] = elements(e, face.corners[c]);
  std::sort(key.begin(), key.end());
  return key;
}

template <class Elements>
std::vector<Key> repeated_faces(const Elements& elements, const std::vector<Face>& faces) {
  std::vector<Key> keys, repeated;
  keys.reserve(static_cast<std::size_t>(elements.rows()) * faces.size());
  for (Eigen::Index e = 0; e < elements.rows(); ++e)
    for (const Face& face : faces) keys.push_back(key_of(elements, e, face));
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (keys[i] == keys[i - 1]) repeated.push_back(keys[i]);
  return repeated;
}

// Numbers the nodes that triangles use, ascending.
void compact(const Points3& nodes, BoundarySurface& surface) {
  std::vector<int> number(static_cast<std::size_t>(nodes.rows()), -1);
  for (const int v : surface.mesh.triangles.reshaped()) number[static_cast<std::size_t>(v)] = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<int>(surface.original_vertex.size());
    surface.original_vertex.push_back(static_cast<int>(v));
  }
  surface.mesh.vertices.resize(static_cast<Eigen::Index>(surface.original_vertex.size()), 3);
  for (Eigen::Index i = 0; i < surface.mesh.vertices.rows(); ++i)
    surface.mesh.vertices.row(i) = nodes.row(surface.original_vertex[static_cast<std::size_t>(i)]);
  for (int& v : surface.mesh.triangles.reshaped()) v = number[static_cast<std::size_t>(v)];
}

template <class Elements>
BoundarySurface surface_of(const Points3& nodes, const Elements& elements, const std::vector<Face>& faces,
                           const char* what) {
  require_indices(elements, nodes.rows(), what);
  const std::vector<Key> inner = repeated_faces(elements, faces);
  BoundarySurface surface;
  std::vector<std::array<int, 3>> triangles;
  for (Eigen::Index e = 0; e < elements.rows(); ++e)
    for (const Face& face : faces) {
      if (std::binary_search(inner.begin(), inner.end(), key_of(elements, e, face))) continue;
      for (const auto& t : face.triangles) {
        triangles.push_back({elements(e, t[0]), elements(e, t[1]), elements(e, t[2])});
        surface.element.push_back(static_cast<int>(e));
      }
    }
  surface.mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    surface.mesh.triangles.row(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1],
        triangles[t][2];
  compact(nodes, surface);
  return surface;
}

}  // namespace

BoundarySurface boundary_surface(const TetMesh& mesh) {
  return surface_of(mesh.vertices, mesh.tets, tet_faces(), "tet");
}

BoundarySurface boundary_surface(const HexMesh& mesh) {
  return surface_of(mesh.vertices, mesh.hexes, hex_faces(), "hex");
}

BoundarySurface boundary_surface(const QuadraticTetMesh& mesh) {
  return surface_of(mesh.nodes, mesh.tets, quadratic_tet_faces(), "quadratic tet");
}

}  // namespace isostretch::mesh
