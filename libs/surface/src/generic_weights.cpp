#include "generic_weights.hpp"

#include <isostretch/mesh/measure.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::mesh {

// The box, unlike sums over vertices, is the same bits in every order.
GenericFunction::GenericFunction(const Points3& vertices) {
  if (vertices.rows() == 0) return;
  double extent[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double low = vertices.col(axis).minCoeff(), high = vertices.col(axis).maxCoeff();
    centre_[axis] = low + 0.5 * (high - low);
    extent[axis] = 0.5 * (high - low);
  }
  const double radius = std::hypot(extent[0], extent[1], extent[2]);
  if (radius > 0) scale_ = 1 / radius;
}

// The shortest waves tell neighbours in fine meshes apart, the longest are for coarse ones.
double GenericFunction::operator()(double x, double y, double z) const {
  x = scale_ * (x - centre_[0]);
  y = scale_ * (y - centre_[1]);
  z = scale_ * (z - centre_[2]);
  return (std::sin(2.31 * x + 3.17 * y + 2.74 * z + 0.71) + std::sin(11.3 * x - 7.9 * y + 9.1 * z + 2.13) +
          std::sin(-31.7 * x + 37.3 * y + 23.9 * z + 4.07)) /
         3;
}

double GenericFunction::height(double x, double y, double z) const {
  return 0.427 * scale_ * (x - centre_[0]) + 0.811 * scale_ * (y - centre_[1]) +
         0.399 * scale_ * (z - centre_[2]) + 0.02 * (*this)(x, y, z);
}

std::vector<double> generic_weights(const HalfEdges& surface, const Points3& vertices) {
  const GenericFunction generic(vertices);
  std::vector<double> weights(surface.opposite.size(), 1);
  if (generic.without_extent()) return weights;
  for (int h = 0; h < surface.count(); ++h) {
    if (!surface.stands_for_edge(h)) continue;
    const int a = surface.from(h), b = surface.to(h);
    const Vector3 along = edge_vector(vertices, a, b);
    const double weight =
        length(along) * (1 + 0.02 * generic(vertices(a, 0) + 0.5 * along[0], vertices(a, 1) + 0.5 * along[1],
                                            vertices(a, 2) + 0.5 * along[2]));
    weights[static_cast<std::size_t>(h)] = weight;
    if (!surface.on_boundary(h))
      weights[static_cast<std::size_t>(surface.opposite[static_cast<std::size_t>(h)])] = weight;
  }
  return weights;
}

int extreme_vertex(const Points3& vertices) {
  const GenericFunction generic(vertices);
  int best = 0;
  double highest = 0;
  for (int v = 0; v < vertices.rows(); ++v) {
    const double height = generic.height(vertices(v, 0), vertices(v, 1), vertices(v, 2));
    if (v == 0 || height > highest) {
      best = v;
      highest = height;
    }
  }
  return best;
}

}  // namespace isostretch::mesh
