#pragma once

#include <isostretch/mesh/accurate.hpp>
#include <isostretch/mesh/types.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace isostretch::mesh {

/// A vector in space.
using Vector3 = std::array<double, 3>;

/// Returns the vector from point `from` to point `to`.
inline Vector3 edge_vector(const Points3& points, int from, int to) {
  return {points(to, 0) - points(from, 0), points(to, 1) - points(from, 1), points(to, 2) - points(from, 2)};
}

/// Returns the scalar product.
inline double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Returns the Euclidean length.
inline double length(const Vector3& a) {
  return std::hypot(a[0], a[1], a[2]);
}

/// Returns the vector product.
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {product_difference(a[1], b[2], a[2], b[1]), product_difference(a[2], b[0], a[0], b[2]),
          product_difference(a[0], b[1], a[1], b[0])};
}

/// Returns the signed area of a triangle in the plane, to about one rounding of the result. `v` has the
/// indices of its corners.
template <class Corners>
double signed_area(const Points2& uv, const Corners& v) {
  return 0.5 * product_difference(uv(v[1], 0) - uv(v[0], 0), uv(v[2], 1) - uv(v[0], 1),
                                  uv(v[1], 1) - uv(v[0], 1), uv(v[2], 0) - uv(v[0], 0));
}

/// The size of a triangle in space, seen from its longest edge: the base runs from corner `first` to the next
/// one, with the third corner above.
struct TriangleShape {
  int first = 0;      ///< Local corner where the base begins.
  double base = 0;    ///< Length of the longest edge.
  double height = 0;  ///< Height of the third corner over the base.
  double before = 0;  ///< Distance of the foot of the height from the beginning of the base.
  double after = 0;   ///< Distance of the foot of the height from the end of the base; before + after = base.
  /// Returns the area.
  double area() const { return 0.5 * base * height; }
  /// Returns whether the triangle is flat to rounding: the height is at most degenerate_height times the
  /// base.
  bool degenerate() const { return !(height > degenerate_height * base); }
};

/// Returns the size of a triangle; `v` has the indices of its corners.
template <class Corners>
TriangleShape triangle_shape(const Points3& points, const Corners& v) {
  Vector3 edge[3];
  double size[3];
  for (int i = 0; i < 3; ++i) {
    edge[i] = edge_vector(points, v[i], v[(i + 1) % 3]);
    size[i] = length(edge[i]);
  }
  TriangleShape shape;
  shape.first = static_cast<int>(std::max_element(size, size + 3) - size);
  shape.base = size[shape.first];
  if (shape.base == 0) return shape;
  const Vector3 &along = edge[shape.first], &up_to = edge[(shape.first + 1) % 3],
                &down_from = edge[(shape.first + 2) % 3];
  // The cross product of the two shorter edges is the one with the smallest error.
  shape.height = length(cross(up_to, down_from)) / shape.base;
  shape.before = -dot(along, down_from) / shape.base;
  shape.after = -dot(along, up_to) / shape.base;
  return shape;
}

/// The size of a tetrahedron: its volume, and the lengths against which zero is judged.
struct TetShape {
  double six_volumes = 0;   ///< Six times the signed volume.
  double longest_edge = 0;  ///< Length of the longest edge.
  double largest_face = 0;  ///< Twice the area of the largest face.
  /// Returns whether the tetrahedron is flat to rounding: its smallest height is at most degenerate_height
  /// times the longest edge.
  bool degenerate() const {
    return !(std::abs(six_volumes) > degenerate_height * largest_face * longest_edge);
  }
};

/// Returns the size of a tetrahedron; `v` has the indices of its corners.
template <class Corners>
TetShape tet_shape(const Points3& points, const Corners& v) {
  TetShape shape;
  const Vector3 a = edge_vector(points, v[0], v[1]), b = edge_vector(points, v[0], v[2]),
                c = edge_vector(points, v[0], v[3]);
  shape.six_volumes = dot(cross(a, b), c);
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      shape.longest_edge = std::max(shape.longest_edge, length(edge_vector(points, v[i], v[j])));
  const Vector3 d = edge_vector(points, v[1], v[2]), e = edge_vector(points, v[1], v[3]);
  for (const Vector3& face : {cross(a, b), cross(a, c), cross(b, c), cross(d, e)})
    shape.largest_face = std::max(shape.largest_face, length(face));
  return shape;
}

}  // namespace isostretch::mesh
