
#include <isostretch/core/index.hpp>
#include <isostretch/mesh/measure.hpp>
#include <isostretch/mesh/require.hpp>
#include <isostretch/surface/repair.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace isostretch::mesh {
namespace {

// From one corner along three edges (two in the plane), with the sign of the volume; at the middle of a hex.
double orientation(const ElementMesh& mesh, int e) {
  const auto edge = [&](int from, int to) {
    return edge_vector(mesh.vertices, mesh.elements(e, from), mesh.elements(e, to));
  };
  if (mesh.shape == Shape::hex) {
    std::array<Vector3, 3> axes{};
    constexpr int edges[3][4][2] = {
        {{0, 1}, {3, 2}, {4, 5}, {7, 6}}, {{0, 3}, {1, 2}, {4, 7}, {5, 6}}, {{0, 4}, {1, 5}, {2, 6}, {3, 7}}};
    for (std::size_t a = 0; a < 3; ++a)
      for (const auto& [from, to] : edges[a]) {
        const Vector3 along = edge(from, to);
        for (std::size_t i = 0; i < 3; ++i) axes[a][i] += along[i];
      }
    return dot(cross(axes[0], axes[1]), axes[2]);
  }
  if (shape_dim(mesh.shape) == 3) return dot(cross(edge(0, 1), edge(0, 2)), edge(0, 3));
  if (mesh.shape == Shape::quad) return cross(edge(0, 2), edge(1, 3))[2];
  return cross(edge(0, 1), edge(0, 2))[2];
}

// Nodes of an element numbered the other way round, by their places.
std::vector<int> turned_places(Shape shape) {
  switch (shape) {
    case Shape::triangle:
      return {0, 2, 1};
    case Shape::quadratic_triangle:
      return {0, 2, 1, 5, 4, 3};
    case Shape::quad:
      return {0, 3, 2, 1};
    case Shape::tet:
      return {0, 1, 3, 2};
    case Shape::quadratic_tet:
      return {0, 1, 3, 2, 4, 8, 7, 6, 5, 9};
    case Shape::hex:
      break;
  }
  return {4, 5, 6, 7, 0, 1, 2, 3};
}

// An element on nodes that another one is on already, and the first on these.
struct Copy {
  int element, original;
};

std::vector<Copy> copies(const ElementMesh& mesh) {
  const auto nodes = static_cast<std::size_t>(mesh.elements.cols());
  std::vector<int> sorted(mesh.elements.data(), mesh.elements.data() + mesh.elements.size());
  for (auto row = sorted.begin(); row < sorted.end(); row += static_cast<std::ptrdiff_t>(nodes))
    std::sort(row, row + static_cast<std::ptrdiff_t>(nodes));
  std::vector<int> order(static_cast<std::size_t>(mesh.elements.rows()));
  std::iota(order.begin(), order.end(), 0);
  const auto compare = [&](int a, int b) {
    const int *x = sorted.data() + nodes * at(a), *y = sorted.data() + nodes * at(b);
    const auto differ = std::mismatch(x, x + nodes, y);
    return differ.first == x + nodes ? 0 : *differ.first - *differ.second;
  };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return compare(a, b) < 0; });
  std::vector<Copy> found;
  for (std::size_t i = 1, first = 0; i < order.size(); ++i)
    if (compare(order[first], order[i]) == 0)
      found.push_back({order[i], order[first]});
    else
      first = i;
  std::sort(found.begin(), found.end(), [](const Copy& a, const Copy& b) { return a.element < b.element; });
  return found;
}

std::vector<int> elements_of(const std::vector<Copy>& copies) {
  std::vector<int> elements;
  for (const Copy& copy : copies) elements.push_back(copy.element);
  return elements;
}

// Originals come into the groups of their copies.
void remove(ElementMesh& mesh, const std::vector<Copy>& copies) {
  if (copies.empty()) return;
  const std::vector<int> elements = elements_of(copies);
  std::vector<int> number(static_cast<std::size_t>(mesh.elements.rows()), -1);
  int kept = 0;
  for (int e = 0; e < mesh.elements.rows(); ++e)
    if (!std::binary_search(elements.begin(), elements.end(), e)) {
      mesh.elements.row(kept) = mesh.elements.row(e);
      number[at(e)] = kept++;
    }
  mesh.elements.conservativeResize(kept, mesh.elements.cols());
  for (const Copy& copy : copies) number[at(copy.element)] = number[at(copy.original)];
  for (ElementGroup& group : mesh.groups) {
    for (int& e : group.elements) e = number[at(e)];
    std::sort(group.elements.begin(), group.elements.end());
    group.elements.erase(std::unique(group.elements.begin(), group.elements.end()), group.elements.end());
  }
}

}  // namespace

ElementRepairReport find_faults(const ElementMesh& mesh) {
  require_indices(mesh.elements, mesh.vertices.rows(), shape_name(mesh.shape));
  ElementRepairReport report{elements_of(copies(mesh)), {}};
  for (int e = 0; e < mesh.elements.rows(); ++e)
    if (orientation(mesh, e) < 0) report.inverted.push_back(e);
  return report;
}

ElementRepairReport repair(ElementMesh& mesh) {
  ElementRepairReport report = find_faults(mesh);
  const std::vector<int> places = turned_places(mesh.shape);
  for (const int e : report.inverted) {
    const std::vector<int> nodes(mesh.elements.data() + mesh.elements.cols() * e,
                                 mesh.elements.data() + mesh.elements.cols() * (e + 1));
    for (std::size_t c = 0; c < places.size(); ++c)
      mesh.elements(e, static_cast<Eigen::Index>(c)) = nodes[at(places[c])];
  }
  remove(mesh, copies(mesh));
  return report;
}

}  // namespace isostretch::mesh
