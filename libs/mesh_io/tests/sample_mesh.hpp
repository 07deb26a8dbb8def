#pragma once

// One small mesh to be written in every format, with faults to order.
#include "meshes.hpp"

#include <isostretch/mesh/types.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace isostretch::mesh::test {

// What a sample says; the defaults are a good mesh.
struct Variation {
  double coordinate = 0.125;   // x of the first vertex
  int corner = -1;             // the last of the last element, from 0; -1: as it should be
  std::int64_t vertices = -1;  // the number that the file claims; -1: as it should be
  std::int64_t elements = -1;
  bool without_elements = false;  // and the claim is 0
};

struct Sample {
  std::string name;  // with the extension, which tells the format
  std::string contents;
  bool tets = false;
  bool text = true;     // messages are by line; otherwise by byte, but for headers
  bool indexed = true;  // corners are indices
  bool counted = true;  // the file claims numbers of vertices and elements
};

inline SurfaceMesh sample_surface() {
  return surface({0.125, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {0, 1, 2, 0, 2, 3});
}

inline TetMesh sample_tets() {
  return {rows<Points3>({0.125, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}),
          rows<Tets>({0, 1, 2, 3, 1, 2, 3, 4})};
}

// The sample mesh with the faults ordered, in the terms that formats share.
struct Model {
  Points3 points;
  std::vector<std::vector<int>> elements;
  std::int64_t point_count;
  std::int64_t element_count;
  int corners;

  explicit Model(bool tets, const Variation& variation) : corners(tets ? 4 : 3) {
    points = tets ? sample_tets().vertices : sample_surface().vertices;
    if (tets)
      take(sample_tets().tets);
    else
      take(sample_surface().triangles);
    points(0, 0) = variation.coordinate;
    if (variation.corner != -1) elements.back().back() = variation.corner;
    if (variation.without_elements) elements.clear();
    point_count = variation.vertices != -1 ? variation.vertices : points.rows();
    element_count =
        variation.elements != -1 ? variation.elements : static_cast<std::int64_t>(elements.size());
  }

  template <class Elements>
  void take(const Elements& rows_of_corners) {
    for (Eigen::Index e = 0; e < rows_of_corners.rows(); ++e)
      elements.emplace_back(rows_of_corners.data() + e * corners, rows_of_corners.data() + (e + 1) * corners);
  }
};

}  // namespace isostretch::mesh::test
