#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

/// Returns the component of every triangle, counted from 0 in the order of their first triangles; triangles
/// that share a vertex belong together. Throws Error when an index is out of range.
std::vector<int> component_of_triangles(const Triangles& triangles, int vertex_count);

/// A part of a mesh as a mesh of its own.
struct Part {
  SurfaceMesh mesh;                    ///< Vertices and triangles of the part; uv is kept.
  std::vector<int> original_vertex;    ///< Vertex of the whole of every vertex of the part, ascending.
  std::vector<int> original_triangle;  ///< Triangle of the whole of every triangle of the part, ascending.
};

/// Returns one part for each component, in the order of component_of_triangles(); unreferenced vertices are
/// left out.
std::vector<Part> split(const SurfaceMesh& mesh);

/// Returns a part for each of the labels 0, 1, ... of triangles, such as the charts of a cut. A vertex of two
/// labels is in both parts. Throws Error for a negative label.
std::vector<Part> split(const SurfaceMesh& mesh, const std::vector<int>& label_of_triangle);

/// Returns all meshes in one, vertices and triangles one mesh after the other. Throws Error when some have uv
/// and some do not.
SurfaceMesh merge(const std::vector<SurfaceMesh>& meshes);

}  // namespace isostretch::mesh
