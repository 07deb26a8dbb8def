#include <isostretch/newton/positions.hpp>

#include <cmath>

namespace isostretch::newton {

double bounding_box_diagonal(const Vector& x, int dim) {
  double squared = 0;
  for (int axis = 0; axis < dim; ++axis) {
    const auto coordinates = x(Eigen::seqN(axis, x.size() / dim, dim));
    const double extent = coordinates.maxCoeff() - coordinates.minCoeff();
    squared += extent * extent;
  }
  return std::sqrt(squared);
}

double rounding_length(const Vector& x, int dim) {
  constexpr double last_digits = 4e-15, epsilon = 2.2e-16;
  return last_digits * bounding_box_diagonal(x, dim) + epsilon * x.cwiseAbs().maxCoeff();
}

}  // namespace isostretch::newton
