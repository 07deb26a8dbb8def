#pragma once

#include <isostretch/mesh/require.hpp>
#include <isostretch/surface/check.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace isostretch::mesh {

// Collects defects up to a number of each kind; the text is only made for those that are kept.
class DefectCollector {
 public:
  DefectCollector(MeshDiagnostics& diagnostics, int max_per_kind)
      : diagnostics_(diagnostics), max_per_kind_(max_per_kind) {}

  template <class MakeText>
  void add(DefectKind kind, std::vector<int> elements, std::vector<int> vertices, const MakeText& text) {
    if (diagnostics_.counts[static_cast<std::size_t>(kind)]++ < max_per_kind_)
      diagnostics_.defects.push_back({kind, std::move(elements), std::move(vertices), text()});
  }

  // "<element> <text>".
  template <class Elements>
  void add_element(DefectKind kind, const char* what, const Elements& elements, Eigen::Index e,
                   const std::string& text) {
    std::vector<int> vertices;
    for (Eigen::Index c = 0; c < elements.cols(); ++c) vertices.push_back(elements(e, c));
    add(kind, {static_cast<int>(e)}, std::move(vertices),
        [&] { return element_text(what, elements, e) + " " + text; });
  }

  void sort() {
    std::stable_sort(diagnostics_.defects.begin(), diagnostics_.defects.end(),
                     [](const Defect& a, const Defect& b) { return a.kind < b.kind; });
  }

 private:
  MeshDiagnostics& diagnostics_;
  int max_per_kind_;
};

struct OrientedPieces;
struct Side;

// Components and their numbers, and the sums of them.
void count_topology(const SurfaceMesh& mesh, const std::vector<Side>& sides, const OrientedPieces& pieces,
                    MeshDiagnostics& diagnostics);

// The checks that triangles and tetrahedra share, and the number of components.
template <class Elements>
void check_elements(const char* what, const Points3& vertices, const Elements& elements,
                    MeshDiagnostics& diagnostics, DefectCollector& defects);

}  // namespace isostretch::mesh
