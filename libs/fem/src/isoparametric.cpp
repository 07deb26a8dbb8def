
#include <isostretch/fem/elements.hpp>
#include <isostretch/fem/shape_functions.hpp>
#include <isostretch/mesh/measure.hpp>
#include <isostretch/mesh/require.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace isostretch::mesh {
namespace {

// Of the map from the reference element to the rest shape, at one point.
template <int Dim>
struct Jacobian {
  using Row = std::array<double, Dim>;
  std::array<Row, Dim> tangent{};  // rest position by each reference coordinate
  std::array<Row, Dim> normal{};   // determinant times rest gradient of each reference coordinate
  double determinant = 0;

  // Longest edge times largest face of the box that the tangents span: the determinant over this is its
  // smallest height over its longest edge.
  double box() const {
    double edge = 0, face = 0;
    for (std::size_t j = 0; j < Dim; ++j) {
      edge = std::max(edge, size(tangent[j]));
      face = std::max(face, size(normal[j]));
    }
    return edge * face;
  }

  static double size(const Row& row) {
    if constexpr (Dim == 2)
      return std::hypot(row[0], row[1]);
    else
      return length(row);
  }
};

void set_normals(Jacobian<2>& J) {
  const auto &a = J.tangent[0], &b = J.tangent[1];
  J.normal = {{{b[1], -b[0]}, {-a[1], a[0]}}};
  J.determinant = product_difference(a[0], b[1], a[1], b[0]);
}

void set_normals(Jacobian<3>& J) {
  const auto& t = J.tangent;
  J.normal = {cross(t[1], t[2]), cross(t[2], t[0]), cross(t[0], t[1])};
  J.determinant = dot(t[0], J.normal[0]);
}

// From positions relative to the first node, of which the gradient is minus the sum of the others': nothing
// is lost far from the origin.
template <int Dim, class Points>
Jacobian<Dim> jacobian(const Points& points, const int* nodes, int node_count, const double* reference) {
  Jacobian<Dim> J;
  for (int a = 1; a < node_count; ++a)
    for (std::size_t j = 0; j < Dim; ++j)
      for (std::size_t d = 0; d < Dim; ++d) {
        const auto axis = static_cast<Eigen::Index>(d);
        J.tangent[j][d] += (points(nodes[a], axis) - points(nodes[0], axis)) *
                           reference[static_cast<std::size_t>(a * Dim) + j];
      }
  set_normals(J);
  return J;
}

// Null when the determinant is positive, beyond rounding of the coordinates.
template <int Dim>
const char* defect(const Jacobian<Dim>& J) {
  if (!std::isfinite(J.determinant)) return "is too large";
  if (!(std::abs(J.determinant) > degenerate_height * J.box())) return "is degenerate (zero Jacobian)";
  return J.determinant < 0 ? "is inverted (negative Jacobian)" : nullptr;
}

template <int Dim>
void rest_gradients(const Jacobian<Dim>& J, int node_count, const double* reference, double* gradients) {
  std::fill_n(gradients, Dim, 0.0);
  for (int a = 1; a < node_count; ++a)
    for (int d = 0; d < Dim; ++d) {
      double g = 0;
      for (int j = 0; j < Dim; ++j)
        g += reference[a * Dim + j] * J.normal[static_cast<std::size_t>(j)][static_cast<std::size_t>(d)];
      gradients[a * Dim + d] = g / J.determinant;
      gradients[d] -= gradients[a * Dim + d];
    }
}

std::vector<double> reference_gradients(Shape shape, const QuadratureRule& rule) {
  const std::size_t dim = static_cast<std::size_t>(rule.dim),
                    block = dim * static_cast<std::size_t>(shape_node_count(shape));
  std::vector<double> gradients(block * rule.weights.size());
  for (std::size_t p = 0; p < rule.weights.size(); ++p)
    shape_gradients(shape, rule.points.data() + p * dim, gradients.data() + p * block);
  return gradients;
}

template <class Cells>
ElementArrays empty_arrays(int dim, const Cells& cells, Eigen::Index node_count, int points) {
  ElementArrays arrays;
  arrays.dim = dim;
  arrays.nodes_per_element = static_cast<int>(cells.cols());
  arrays.points_per_element = points;
  arrays.node_count = static_cast<int>(node_count);
  arrays.nodes.assign(cells.data(), cells.data() + cells.size());
  arrays.gradients.resize(static_cast<std::size_t>(cells.size() * dim * points));
  arrays.weights.resize(static_cast<std::size_t>(cells.rows() * points));
  return arrays;
}

template <class Points, class Cells>
ElementArrays isoparametric(Shape shape, const Points& points, const Cells& cells, int degree) {
  constexpr int Dim = Points::ColsAtCompileTime, Nodes = Cells::ColsAtCompileTime;
  require_any(cells, shape_name(shape));
  require_indices(cells, points.rows(), shape_name(shape));
  require_finite(points, "vertex");
  const QuadratureRule rule = quadrature_rule(shape, degree);
  const std::vector<double> reference = reference_gradients(shape, rule);
  ElementArrays arrays = empty_arrays(Dim, cells, points.rows(), rule.size());
  double *gradients = arrays.gradients.data(), *weight = arrays.weights.data();
  for (Eigen::Index e = 0; e < cells.rows(); ++e)
    for (int p = 0; p < rule.size(); ++p, gradients += Dim * Nodes, ++weight) {
      const double* at = reference.data() + p * Dim * Nodes;
      const Jacobian<Dim> J = jacobian<Dim>(points, cells.data() + e * Nodes, Nodes, at);
      if (const char* why = defect(J))
        throw Error(element_text(shape_name(shape), cells, e) + " " + why + " at quadrature point " +
                    std::to_string(p));
      rest_gradients(J, Nodes, at, gradients);
      *weight = rule.weights[static_cast<std::size_t>(p)] * J.determinant;
    }
  return arrays;
}

}  // namespace

ElementArrays elements(const QuadMesh& mesh, int degree) {
  return isoparametric(Shape::quad, mesh.vertices, mesh.quads, degree);
}

ElementArrays elements(const HexMesh& mesh, int degree) {
  return isoparametric(Shape::hex, mesh.vertices, mesh.hexes, degree);
}

ElementArrays elements(const QuadraticTriangleMesh& mesh, int degree) {
  return isoparametric(Shape::quadratic_triangle, mesh.nodes, mesh.triangles, degree);
}

ElementArrays elements(const QuadraticTetMesh& mesh, int degree) {
  return isoparametric(Shape::quadratic_tet, mesh.nodes, mesh.tets, degree);
}

}  // namespace isostretch::mesh
