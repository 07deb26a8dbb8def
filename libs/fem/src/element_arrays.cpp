
#include <isostretch/core/to_text.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/measure.hpp>
#include <isostretch/mesh/require.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::mesh {
namespace {

template <class Elements>
ElementArrays linear_elements(const Elements& elements, Eigen::Index node_count, int dim) {
  ElementArrays arrays;
  arrays.dim = dim;
  arrays.nodes_per_element = static_cast<int>(elements.cols());
  arrays.points_per_element = 1;
  arrays.node_count = static_cast<int>(node_count);
  arrays.nodes.assign(elements.data(), elements.data() + elements.size());
  arrays.gradients.resize(static_cast<std::size_t>(elements.size() * dim));
  arrays.weights.resize(static_cast<std::size_t>(elements.rows()));
  return arrays;
}

template <class Elements>
[[noreturn]] void refuse(const char* what, const Elements& elements, Eigen::Index e, const char* why) {
  throw Error(element_text(what, elements, e) + " " + why);
}

// Gradients of the hat functions in the frame of the longest edge: corners (0, 0), (base, 0), (before,
// height). Each is the opposite edge turned by 90 degrees over twice the area, written so that thin triangles
// lose nothing.
void flat_gradients(const TriangleShape& s, double* gradients) {
  double* first = gradients + 2 * s.first;
  double* second = gradients + 2 * ((s.first + 1) % 3);
  double* third = gradients + 2 * ((s.first + 2) % 3);
  first[0] = -1 / s.base;
  first[1] = -(s.after / s.base) / s.height;
  second[0] = 1 / s.base;
  second[1] = -(s.before / s.base) / s.height;
  third[0] = 0;
  third[1] = 1 / s.height;
}

struct PlanarShape {
  double edge[3][2];  // edge[i]: opposite corner i, from corner i + 1 to corner i + 2
  double twice_area;
  double longest;
};

PlanarShape planar_shape(const Points2& points, const int* v) {
  PlanarShape s;
  s.longest = 0;
  for (int i = 0; i < 3; ++i) {
    for (int d = 0; d < 2; ++d) s.edge[i][d] = points(v[(i + 2) % 3], d) - points(v[(i + 1) % 3], d);
    s.longest = std::max(s.longest, std::hypot(s.edge[i][0], s.edge[i][1]));
  }
  s.twice_area = product_difference(s.edge[0][0], s.edge[1][1], s.edge[0][1], s.edge[1][0]);
  return s;
}

// Row i of the inverse of the edge matrix is a cross product over six times the volume.
void tet_gradients(const Points3& points, const int* v, double six_volumes, double* gradients) {
  const Vector3 a = edge_vector(points, v[0], v[1]), b = edge_vector(points, v[0], v[2]),
                c = edge_vector(points, v[0], v[3]);
  const Vector3 normals[3] = {cross(b, c), cross(c, a), cross(a, b)};
  for (int d = 0; d < 3; ++d) gradients[d] = 0;
  for (int i = 0; i < 3; ++i)
    for (int d = 0; d < 3; ++d) {
      const double g = normals[i][static_cast<std::size_t>(d)] / six_volumes;
      gradients[3 * (i + 1) + d] = g;
      gradients[d] -= g;
    }
}

}  // namespace

ElementArrays flat_elements(const SurfaceMesh& mesh) {
  require_any(mesh.triangles, "triangle");
  require_indices(mesh.triangles, mesh.vertices.rows(), "triangle");
  require_finite(mesh.vertices, "vertex");
  ElementArrays arrays = linear_elements(mesh.triangles, mesh.vertices.rows(), 2);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const TriangleShape shape = triangle_shape(mesh.vertices, mesh.triangles.data() + 3 * t);
    if (shape.degenerate()) refuse("triangle", mesh.triangles, t, "has zero area");
    flat_gradients(shape, arrays.gradients.data() + 6 * t);
    arrays.weights[static_cast<std::size_t>(t)] = shape.area();
  }
  return arrays;
}

ElementArrays elements(const Points2& vertices, const Triangles& triangles) {
  require_any(triangles, "triangle");
  require_indices(triangles, vertices.rows(), "triangle");
  require_finite(vertices, "vertex");
  ElementArrays arrays = linear_elements(triangles, vertices.rows(), 2);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const PlanarShape s = planar_shape(vertices, triangles.data() + 3 * t);
    if (!(std::abs(s.twice_area) > degenerate_height * s.longest * s.longest))
      refuse("triangle", triangles, t, "has zero area");
    if (s.twice_area < 0) refuse("triangle", triangles, t, "is clockwise (negative area)");
    double* gradients = arrays.gradients.data() + 6 * t;
    for (int i = 0; i < 3; ++i) {
      gradients[2 * i] = -s.edge[i][1] / s.twice_area;
      gradients[2 * i + 1] = s.edge[i][0] / s.twice_area;
    }
    arrays.weights[static_cast<std::size_t>(t)] = 0.5 * s.twice_area;
  }
  return arrays;
}

ElementArrays elements(const TetMesh& mesh) {
  require_any(mesh.tets, "tet");
  require_indices(mesh.tets, mesh.vertices.rows(), "tet");
  require_finite(mesh.vertices, "vertex");
  ElementArrays arrays = linear_elements(mesh.tets, mesh.vertices.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
    const int* v = mesh.tets.data() + 4 * t;
    const TetShape shape = tet_shape(mesh.vertices, v);
    if (shape.degenerate()) refuse("tet", mesh.tets, t, "has zero volume");
    if (shape.six_volumes < 0) refuse("tet", mesh.tets, t, "is inverted (negative volume)");
    tet_gradients(mesh.vertices, v, shape.six_volumes, arrays.gradients.data() + 12 * t);
    arrays.weights[static_cast<std::size_t>(t)] = shape.six_volumes / 6;
  }
  return arrays;
}

double total_area(const SurfaceMesh& mesh) {
  require_indices(mesh.triangles, mesh.vertices.rows(), "triangle");
  double sum = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    sum += triangle_shape(mesh.vertices, mesh.triangles.data() + 3 * t).area();
  return sum;
}

double total_weight(const ElementArrays& elements) {
  double sum = 0;
  for (const double weight : elements.weights) sum += weight;
  return sum;
}

double scale_to_total_weight(ElementArrays& elements, double target) {
  const double total = total_weight(elements);
  if (!(total > 0 && target > 0 && std::isfinite(target)))
    throw Error("cannot scale a total area of " + to_text(total) + " to " + to_text(target));
  const double factor = std::pow(target / total, 1.0 / elements.dim);
  for (double& weight : elements.weights) weight *= target / total;
  for (double& gradient : elements.gradients) gradient /= factor;
  return factor;
}

}  // namespace isostretch::mesh
