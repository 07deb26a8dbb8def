#include "defects.hpp"

#include <isostretch/surface/topology.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace isostretch::mesh {
namespace {

template <class Elements>
void check_indices(const char* what, const Points3& vertices, const Elements& elements,
                   MeshDiagnostics& diagnostics, DefectCollector& defects) {
  for (Eigen::Index e = 0; e < elements.rows(); ++e)
    if (!indices_in_range(elements, e, vertices.rows())) {
      diagnostics.indices_valid = false;
      defects.add_element(
          DefectKind::index_out_of_range, what, elements, e,
          "has an index out of range: there are " + std::to_string(vertices.rows()) + " vertices");
    }
}

void check_finite(const Points3& vertices, DefectCollector& defects) {
  for (Eigen::Index i = 0; i < vertices.rows(); ++i)
    if (!(std::isfinite(vertices(i, 0)) && std::isfinite(vertices(i, 1)) && std::isfinite(vertices(i, 2))))
      defects.add(DefectKind::not_finite, {}, {static_cast<int>(i)},
                  [&] { return "vertex " + std::to_string(i) + " has a coordinate that is not finite"; });
}

template <class Elements>
bool repeats_vertex(const Elements& elements, Eigen::Index e) {
  for (Eigen::Index a = 0; a < elements.cols(); ++a)
    for (Eigen::Index b = 0; b < a; ++b)
      if (elements(e, a) == elements(e, b)) return true;
  return false;
}

template <class Elements>
void check_duplicates(const char* what, const Elements& elements, DefectCollector& defects) {
  using Key =
      std::array<int, static_cast<std::size_t>(Elements::ColsAtCompileTime) + 1>;  // vertices, element
  std::vector<Key> keys(static_cast<std::size_t>(elements.rows()));
  for (Eigen::Index e = 0; e < elements.rows(); ++e) {
    Key& key = keys[static_cast<std::size_t>(e)];
    for (Eigen::Index c = 0; c < elements.cols(); ++c) key[static_cast<std::size_t>(c)] = elements(e, c);
    std::sort(key.begin(), key.end() - 1);
    key.back() = static_cast<int>(e);
  }
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (std::equal(keys[i].begin(), keys[i].end() - 1, keys[i - 1].begin()))
      defects.add_element(
          DefectKind::duplicate_element, what, elements, keys[i].back(),
          "has the vertices of " + std::string(what) + " " + std::to_string(keys[i - 1].back()));
}

template <class Elements>
std::vector<int> component_of_vertices(const Points3& vertices, const Elements& elements) {
  UnionFind sets(static_cast<int>(vertices.rows()));
  for (Eigen::Index e = 0; e < elements.rows(); ++e)
    for (Eigen::Index c = 1; c < elements.cols(); ++c) sets.unite(elements(e, 0), elements(e, c));
  std::vector<int> roots(static_cast<std::size_t>(vertices.rows()));
  for (std::size_t i = 0; i < roots.size(); ++i) roots[i] = sets.find(static_cast<int>(i));
  return roots;
}

template <class Elements>
void check_components(const char* what, const Points3& vertices, const Elements& elements,
                      MeshDiagnostics& diagnostics, DefectCollector& defects) {
  const std::vector<int> root = component_of_vertices(vertices, elements);
  std::vector<char> seen(root.size(), 0);
  std::vector<int> examples;  // first element of every component
  for (Eigen::Index e = 0; e < elements.rows(); ++e) {
    char& known = seen[static_cast<std::size_t>(root[static_cast<std::size_t>(elements(e, 0))])];
    if (!known) examples.push_back(static_cast<int>(e));
    known = 1;
  }
  diagnostics.components = static_cast<int>(examples.size());
  if (examples.size() < 2) return;
  std::string list;
  for (std::size_t i = 0; i < examples.size() && i < 5; ++i)
    list += (i ? ", " : "") + std::to_string(examples[i]);
  defects.add(DefectKind::several_components, examples, {}, [&] {
    return std::to_string(examples.size()) + " components, with " + what + "s " + list +
           (examples.size() > 5 ? ", ..." : "");
  });
}

template <class Elements>
void check_references(const Points3& vertices, const Elements& elements, DefectCollector& defects) {
  std::vector<char> used(static_cast<std::size_t>(vertices.rows()), 0);
  for (Eigen::Index e = 0; e < elements.rows(); ++e)
    for (Eigen::Index c = 0; c < elements.cols(); ++c) used[static_cast<std::size_t>(elements(e, c))] = 1;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i])
      defects.add(DefectKind::unreferenced_vertex, {}, {static_cast<int>(i)},
                  [&] { return "vertex " + std::to_string(i) + " belongs to no element"; });
}

void check_duplicate_vertices(const Points3& vertices, DefectCollector& defects) {
  const auto less = [&](int a, int b) {
    const double *p = vertices.data() + 3 * a, *q = vertices.data() + 3 * b;
    return std::lexicographical_compare(p, p + 3, q, q + 3);
  };
  std::vector<int> order;
  for (Eigen::Index i = 0; i < vertices.rows(); ++i)
    if (vertices.row(i).allFinite()) order.push_back(static_cast<int>(i));
  std::stable_sort(order.begin(), order.end(), less);
  std::vector<std::pair<int, int>> duplicates;  // vertex, earlier one
  for (std::size_t i = 1, first = 0; i < order.size(); ++i)
    if (less(order[first], order[i]))
      first = i;
    else
      duplicates.emplace_back(order[i], order[first]);
  std::sort(duplicates.begin(), duplicates.end());
  for (const auto& [vertex, earlier] : duplicates)
    defects.add(DefectKind::duplicate_vertex, {}, {vertex, earlier}, [&, a = vertex, b = earlier] {
      return "vertex " + std::to_string(a) + " is where vertex " + std::to_string(b) + " is";
    });
}

}  // namespace

template <class Elements>
void check_elements(const char* what, const Points3& vertices, const Elements& elements,
                    MeshDiagnostics& diagnostics, DefectCollector& defects) {
  check_indices(what, vertices, elements, diagnostics, defects);
  check_finite(vertices, defects);
  if (!diagnostics.indices_valid) return;
  for (Eigen::Index e = 0; e < elements.rows(); ++e)
    if (repeats_vertex(elements, e))
      defects.add_element(DefectKind::degenerate, what, elements, e, "repeats a vertex");
  check_duplicates(what, elements, defects);
  check_references(vertices, elements, defects);
  check_duplicate_vertices(vertices, defects);
  check_components(what, vertices, elements, diagnostics, defects);
}

template void check_elements(const char*, const Points3&, const Triangles&, MeshDiagnostics&,
                             DefectCollector&);
template void check_elements(const char*, const Points3&, const Tets&, MeshDiagnostics&, DefectCollector&);

std::string_view defect_kind_name(DefectKind kind) noexcept {
  static constexpr std::string_view names[defect_kind_count] = {
      "index out of range",  "coordinate not finite", "degenerate element",       "zero size",
      "inverted element",    "duplicate element",     "non-manifold edge",        "non-manifold face",
      "non-manifold vertex", "not orientable",        "inconsistent orientation", "unreferenced vertex",
      "duplicate vertex",    "several components"};
  return names[static_cast<std::size_t>(kind)];
}

bool MeshDiagnostics::clean() const {
  return std::all_of(defects.begin(), defects.end(),
                     [](const Defect& defect) { return defect.kind == DefectKind::duplicate_vertex; });
}

const Defect* MeshDiagnostics::find(DefectKind kind) const {
  for (const Defect& defect : defects)
    if (defect.kind == kind) return &defect;
  return nullptr;
}

}  // namespace isostretch::mesh
