#pragma once

// Shapes of elements, and the unit square or cube in elements of any of them, its nodes moved by a map.
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/fem/elements.hpp>
#include <isostretch/fem/quadratic.hpp>
#include <isostretch/fem/quadrature.hpp>
#include <isostretch/fem/shape_functions.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/shape.hpp>
#include <isostretch/mesh/structured.hpp>

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace isostretch::mesh::test {

inline constexpr Shape shapes[] = {Shape::triangle, Shape::quadratic_triangle, Shape::quad,
                                   Shape::tet,      Shape::quadratic_tet,      Shape::hex};

inline std::vector<Shape> isoparametric_shapes() {
  return {Shape::quadratic_triangle, Shape::quad, Shape::quadratic_tet, Shape::hex};
}

// A mesh of any shape: nodes in rows, and its arrays.
struct Sample {
  Eigen::MatrixXd nodes;
  ElementArrays arrays;
};

using Map = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

template <class Points>
void move_nodes(Points& points, const Map& map) {
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = map(Eigen::VectorXd(points.row(i).transpose())).transpose();
}

// The unit square or cube in 2 x 2 (x 2) boxes of that shape, every node moved by the map.
inline Sample box_mesh(Shape shape, int degree, const Map& map) {
  SurfaceMesh flat = grid(2, 2);
  Points2 plane = flat.vertices.leftCols<2>();
  TetMesh bar = tet_bar(2, 2, 2);
  if (shape == Shape::quad) {
    QuadMesh mesh = quad_grid(2, 2);
    move_nodes(mesh.vertices, map);
    return {mesh.vertices, elements(mesh, degree)};
  }
  if (shape == Shape::hex) {
    HexMesh mesh = hex_bar(2, 2, 2);
    move_nodes(mesh.vertices, map);
    return {mesh.vertices, elements(mesh, degree)};
  }
  if (shape == Shape::quadratic_triangle) {
    QuadraticTriangleMesh mesh = quadratic(plane, flat.triangles);
    move_nodes(mesh.nodes, map);
    return {mesh.nodes, elements(mesh, degree)};
  }
  if (shape == Shape::quadratic_tet) {
    QuadraticTetMesh mesh = quadratic(bar);
    move_nodes(mesh.nodes, map);
    return {mesh.nodes, elements(mesh, degree)};
  }
  if (shape == Shape::triangle) {
    move_nodes(plane, map);
    return {plane, elements(plane, flat.triangles)};
  }
  move_nodes(bar.vertices, map);
  return {bar.vertices, elements(bar)};
}

inline int point_count(const ElementArrays& e) {
  return static_cast<int>(e.weights.size());
}

// Place of a quadrature point by the shape functions.
inline Eigen::VectorXd place(Shape shape, const QuadratureRule& rule, const Sample& sample, int point) {
  const int n = sample.arrays.nodes_per_element, p = point % rule.size(), e = point / rule.size();
  std::vector<double> values(static_cast<std::size_t>(n));
  shape_values(shape, rule.points.data() + p * rule.dim, values.data());
  Eigen::VectorXd x = Eigen::VectorXd::Zero(rule.dim);
  for (int a = 0; a < n; ++a)
    x += values[static_cast<std::size_t>(a)] *
         sample.nodes.row(sample.arrays.nodes[static_cast<std::size_t>(e * n + a)]).transpose();
  return x;
}

}  // namespace isostretch::mesh::test
