#pragma once

#include <isostretch/mesh/require.hpp>
#include <isostretch/surface/check.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace isostretch::mesh {

// Collects findings up to a number of each kind; the text is only made for those that are kept.
class Findings {
 public:
  Findings(Report& report, int max_per_kind) : report_(report), max_per_kind_(max_per_kind) {}

  template <class MakeText>
  void add(Kind kind, std::vector<int> elements, std::vector<int> vertices, const MakeText& text) {
    if (report_.counts[static_cast<std::size_t>(kind)]++ < max_per_kind_)
      report_.findings.push_back({kind, std::move(elements), std::move(vertices), text()});
  }

  // "<element> <text>".
  template <class Elements>
  void add_element(Kind kind, const char* what, const Elements& elements, Eigen::Index e,
                   const std::string& text) {
    std::vector<int> vertices;
    for (Eigen::Index c = 0; c < elements.cols(); ++c) vertices.push_back(elements(e, c));
    add(kind, {static_cast<int>(e)}, std::move(vertices),
        [&] { return element_text(what, elements, e) + " " + text; });
  }

  void sort() {
    std::stable_sort(report_.findings.begin(), report_.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.kind < b.kind; });
  }

 private:
  Report& report_;
  int max_per_kind_;
};

struct OrientedPieces;
struct Side;

// Components and their numbers, and the sums of them.
void count_topology(const SurfaceMesh& mesh, const std::vector<Side>& sides, const OrientedPieces& pieces,
                    Report& report);

// The checks that triangles and tetrahedra share, and the number of components.
template <class Elements>
void check_elements(const char* what, const Points3& vertices, const Elements& elements, Report& report,
                    Findings& findings);

}  // namespace isostretch::mesh
