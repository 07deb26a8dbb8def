#pragma once

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/types.hpp>

#include <cmath>
#include <string>

namespace isostretch::mesh {

/// Returns the vertices of an element as they are numbered in the mesh: "9987 9970 9494".
template <class Elements>
std::string vertex_list(const Elements& elements, Eigen::Index element) {
  std::string text;
  for (Eigen::Index c = 0; c < elements.cols(); ++c) {
    if (c > 0) text += ' ';
    text += std::to_string(elements(element, c));
  }
  return text;
}

/// Returns an element with its vertices for a message: "triangle 18564 (vertices 9987 9970 9494)". `what` is
/// the name of its shape.
template <class Elements>
std::string element_text(const char* what, const Elements& elements, Eigen::Index element) {
  return std::string(what) + " " + std::to_string(element) + " (vertices " + vertex_list(elements, element) +
         ")";
}

/// Returns whether all vertices of an element are in 0 ... count - 1.
template <class Elements>
bool indices_in_range(const Elements& elements, Eigen::Index element, Eigen::Index count) {
  for (Eigen::Index c = 0; c < elements.cols(); ++c)
    if (elements(element, c) < 0 || elements(element, c) >= count) return false;
  return true;
}

/// Throws Error if there are no elements. `what` is the name of their shape.
template <class Elements>
void require_any(const Elements& elements, const char* what) {
  if (elements.rows() == 0)
    throw Error(std::string("the mesh is empty: there is no ") + what + " to make elements of");
}

/// Throws Error naming the first point with a coordinate that is not finite. `what` is the name of the
/// points, such as vertex.
template <class Points>
void require_finite(const Points& points, const char* what) {
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    for (Eigen::Index c = 0; c < points.cols(); ++c)
      if (!std::isfinite(points(i, c)))
        throw Error(std::string(what) + " " + std::to_string(i) + " has a coordinate that is not finite");
}

/// Throws Error naming the first element with a vertex outside 0 ... count - 1. `what` is the name of its
/// shape.
template <class Elements>
void require_indices(const Elements& elements, Eigen::Index count, const char* what) {
  for (Eigen::Index e = 0; e < elements.rows(); ++e)
    if (!indices_in_range(elements, e, count))
      throw Error(element_text(what, elements, e) + ": index out of range, there are " +
                  std::to_string(count) + " points");
}

/// Throws Error naming the vertex or triangle unless coordinates are finite, indices in range, and texture
/// coordinates, if there are any, given by one triangle for each of the surface.
inline void require_consistent(const SurfaceMesh& mesh) {
  require_finite(mesh.vertices, "vertex");
  require_indices(mesh.triangles, mesh.vertices.rows(), "triangle");
  if (!mesh.has_uv()) return;
  if (mesh.uv_triangles.rows() != mesh.triangles.rows())
    throw Error(std::to_string(mesh.uv_triangles.rows()) + " uv triangles for " +
                std::to_string(mesh.triangles.rows()) + " triangles");
  require_finite(mesh.uv, "uv point");
  require_indices(mesh.uv_triangles, mesh.uv.rows(), "uv triangle");
}

}  // namespace isostretch::mesh
