#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

/// Component of every triangle, counted from 0 in the order of their first triangles; triangles that share a
/// vertex belong together. Throws Error when an index is out of range.
std::vector<int> component_of_triangles(const Triangles& triangles, int vertex_count);

struct Part {
  SurfaceMesh mesh;                    ///< uv is kept
  std::vector<int> original_vertex;    ///< vertex of the part -> vertex of the whole, ascending
  std::vector<int> original_triangle;  ///< the same for triangles
};

/// One part for each component, in the order of component_of_triangles; unreferenced vertices are left out.
std::vector<Part> split(const SurfaceMesh& mesh);

/// Parts by labels 0, 1, ... of the triangles, such as the charts of a cut. A vertex of two labels is in both
/// parts. A negative label throws Error.
std::vector<Part> split(const SurfaceMesh& mesh, const std::vector<int>& label_of_triangle);

/// All meshes in one, vertices and triangles one mesh after the other. Throws Error when some have uv and
/// some do not.
SurfaceMesh merge(const std::vector<SurfaceMesh>& meshes);

}  // namespace isostretch::mesh
