#include "simplex_edges.hpp"

#include <isostretch/fem/shape_functions.hpp>

#include <array>

namespace isostretch::mesh {
namespace {

template <int Dim>
std::array<double, Dim + 1> barycentric(const double* point) {
  std::array<double, Dim + 1> lambda;
  lambda[0] = 1;
  for (std::size_t d = 0; d < Dim; ++d) {
    lambda[d + 1] = point[d];
    lambda[0] -= point[d];
  }
  return lambda;
}

// Of a barycentric coordinate along an axis.
double slope(int corner, int axis) {
  return corner == 0 ? -1.0 : corner == axis + 1 ? 1.0 : 0.0;
}

template <int Dim>
void linear_values(const double* point, double* values) {
  const auto lambda = barycentric<Dim>(point);
  for (std::size_t a = 0; a <= Dim; ++a) values[a] = lambda[a];
}

template <int Dim>
void linear_gradients(double* gradients) {
  for (int a = 0; a <= Dim; ++a)
    for (int d = 0; d < Dim; ++d) gradients[a * Dim + d] = slope(a, d);
}

template <int Dim>
void quadratic_values(const double* point, double* values) {
  const auto lambda = barycentric<Dim>(point);
  for (std::size_t a = 0; a <= Dim; ++a) values[a] = lambda[a] * (2 * lambda[a] - 1);
  for (int e = 0; e < simplex_edge_count<Dim>; ++e) {
    const auto i = static_cast<std::size_t>(simplex_edges[e][0]),
               j = static_cast<std::size_t>(simplex_edges[e][1]);
    values[Dim + 1 + e] = 4 * lambda[i] * lambda[j];
  }
}

template <int Dim>
void quadratic_gradients(const double* point, double* gradients) {
  const auto lambda = barycentric<Dim>(point);
  for (int a = 0; a <= Dim; ++a)
    for (int d = 0; d < Dim; ++d)
      gradients[a * Dim + d] = (4 * lambda[static_cast<std::size_t>(a)] - 1) * slope(a, d);
  for (int e = 0; e < simplex_edge_count<Dim>; ++e) {
    const int i = simplex_edges[e][0], j = simplex_edges[e][1];
    for (int d = 0; d < Dim; ++d)
      gradients[(Dim + 1 + e) * Dim + d] = 4 * (lambda[static_cast<std::size_t>(i)] * slope(j, d) +
                                                lambda[static_cast<std::size_t>(j)] * slope(i, d));
  }
}

// On which end of each axis of the cube a corner is; the first four are those of the square.
constexpr int cube_corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

double hat(int end, double x) {
  return end == 1 ? x : 1 - x;
}

template <int Dim>
void multilinear_values(const double* point, double* values) {
  for (int a = 0; a < 1 << Dim; ++a) {
    values[a] = 1;
    for (int d = 0; d < Dim; ++d) values[a] *= hat(cube_corner[a][d], point[d]);
  }
}

template <int Dim>
void multilinear_gradients(const double* point, double* gradients) {
  for (int a = 0; a < 1 << Dim; ++a)
    for (int d = 0; d < Dim; ++d) {
      double product = cube_corner[a][d] == 1 ? 1 : -1;
      for (int other = 0; other < Dim; ++other)
        if (other != d) product *= hat(cube_corner[a][other], point[other]);
      gradients[a * Dim + d] = product;
    }
}

}  // namespace

void shape_values(Shape shape, const double* point, double* values) noexcept {
  switch (shape) {
    case Shape::triangle:
      return linear_values<2>(point, values);
    case Shape::quadratic_triangle:
      return quadratic_values<2>(point, values);
    case Shape::quad:
      return multilinear_values<2>(point, values);
    case Shape::tet:
      return linear_values<3>(point, values);
    case Shape::quadratic_tet:
      return quadratic_values<3>(point, values);
    case Shape::hex:
      return multilinear_values<3>(point, values);
  }
}

void shape_gradients(Shape shape, const double* point, double* gradients) noexcept {
  switch (shape) {
    case Shape::triangle:
      return linear_gradients<2>(gradients);
    case Shape::quadratic_triangle:
      return quadratic_gradients<2>(point, gradients);
    case Shape::quad:
      return multilinear_gradients<2>(point, gradients);
    case Shape::tet:
      return linear_gradients<3>(gradients);
    case Shape::quadratic_tet:
      return quadratic_gradients<3>(point, gradients);
    case Shape::hex:
      return multilinear_gradients<3>(point, gradients);
  }
}

}  // namespace isostretch::mesh
