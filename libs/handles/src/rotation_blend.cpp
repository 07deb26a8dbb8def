#include <isostretch/core/error.hpp>
#include <isostretch/core/index.hpp>
#include <isostretch/handles/rotation_blend.hpp>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <string>

namespace isostretch::handles {
namespace {

using Quaternion = Eigen::Vector4d;  // (x, y, z, w)

std::string rotation_name(std::size_t h) {
  return "rotations: the turn of handle " + std::to_string(h);
}

// Axes of length one, z in 2D, and angles in radians.
struct Rotations {
  std::vector<Point> axes;
  std::vector<double> angles;
};

Rotations rotations_of(const std::vector<AxisAngle>& axis_angles, int dim) {
  Rotations result;
  for (std::size_t h = 0; h < axis_angles.size(); ++h) {
    const AxisAngle& given = axis_angles[h];
    if (!std::isfinite(given.degrees)) throw Error(rotation_name(h) + " is not finite");
    Point axis = Point::UnitZ();
    if (dim == 3) {
      if (!given.axis.allFinite()) throw Error(rotation_name(h) + " has an axis that is not finite");
      if (given.axis.isZero(0)) throw Error(rotation_name(h) + " has an axis of length zero");
      axis = (given.axis / given.axis.cwiseAbs().maxCoeff()).normalized();
    }
    result.axes.push_back(axis);
    result.angles.push_back(given.degrees * std::numbers::pi / 180);
  }
  return result;
}

// Turns the others to the axis of the first that axis_angles at all.
void share_axis(Rotations& rotations) {
  constexpr double same = 1e-12;
  std::size_t first = 0;
  while (first + 1 < rotations.angles.size() && rotations.angles[first] == 0) ++first;
  const Point axis = rotations.axes[first];
  for (std::size_t h = 0; h < rotations.axes.size(); ++h) {
    if (rotations.angles[h] != 0 && axis.cross(rotations.axes[h]).norm() > same)
      throw Error(rotation_name(h) + " has another axis than that of handle " + std::to_string(first) +
                  ": angles alone cannot be blended");
    if (axis.dot(rotations.axes[h]) < 0) rotations.angles[h] = -rotations.angles[h];
    rotations.axes[h] = axis;
  }
}

std::vector<Quaternion> quaternions_of(const Rotations& rotations, bool aligned) {
  std::vector<Quaternion> result;
  for (std::size_t h = 0; h < rotations.axes.size(); ++h) {
    const double half = 0.5 * rotations.angles[h];
    Quaternion q;
    q << std::sin(half) * rotations.axes[h], std::cos(half);
    if (aligned && h > 0 && q.dot(result.front()) < 0) q = -q;
    result.push_back(q);
  }
  return result;
}

// Of axis * angle.
Eigen::Matrix3d exponential(const Point& vector) {
  const double angle = vector.norm();
  if (angle == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

Eigen::Matrix3d normalized_sum(const std::vector<Quaternion>& quaternions, const std::vector<double>& share,
                               int element) {
  Quaternion sum = Quaternion::Zero();
  for (std::size_t h = 0; h < share.size(); ++h) sum += share[h] * quaternions[h];
  const double length = sum.norm();
  if (!(length > 1e-8))
    throw Error("rotations: the quaternions of element " + std::to_string(element) + " cancel each other");
  return Eigen::Quaterniond(sum / length).toRotationMatrix();
}

Eigen::Matrix3d exponential_sum(const Rotations& rotations, const std::vector<double>& share) {
  Point sum = Point::Zero();
  for (std::size_t h = 0; h < share.size(); ++h) sum += share[h] * rotations.angles[h] * rotations.axes[h];
  return exponential(sum);
}

void mean_weights(const assembly::Elements& elements, const HandleWeights& weights, int element,
                  std::vector<double>& share) {
  const int k = elements.nodes_per_element;
  for (int h = 0; h < weights.handles; ++h) {
    double sum = 0;
    for (int a = 0; a < k; ++a) sum += weights.at(elements.nodes[at(element) * at(k) + at(a)], h);
    share[at(h)] = sum / k;
  }
}

void require_fit(const assembly::Elements& elements, const HandleWeights& weights, std::size_t axis_angles) {
  if (axis_angles == 0 || at(weights.handles) != axis_angles)
    throw Error("rotations: " + std::to_string(axis_angles) + " turns for the weights of " +
                std::to_string(weights.handles) + " handles");
  if (weights.values.size() != at(elements.node_count) * axis_angles)
    throw Error("rotations: " + std::to_string(weights.values.size()) + " weights for " +
                std::to_string(elements.node_count) + " nodes and " + std::to_string(axis_angles) +
                " handles");
  for (std::size_t i = 0; i < weights.values.size(); ++i)
    if (!std::isfinite(weights.values[i]))
      throw Error("rotations: a weight of node " + std::to_string(i / axis_angles) + " is not finite");
}

}  // namespace

RotationBlend default_blend(int dim) {
  return dim == 2 ? RotationBlend::angle : RotationBlend::quaternion;
}

std::vector<double> blended_rotations(const assembly::Elements& elements, const HandleWeights& weights,
                                      const std::vector<AxisAngle>& axis_angles, RotationBlend blend) {
  elements.validate();
  require_fit(elements, weights, axis_angles.size());
  const int dim = elements.dim;
  Rotations rotations = rotations_of(axis_angles, dim);
  if (blend == RotationBlend::angle) share_axis(rotations);
  const bool by_vector = blend == RotationBlend::angle || blend == RotationBlend::rotation_vector;
  const auto quaternions = quaternions_of(rotations, blend == RotationBlend::aligned_quaternion);
  std::vector<double> result, share(axis_angles.size());
  result.reserve(at(elements.element_count()) * at(dim * dim));
  for (int e = 0; e < elements.element_count(); ++e) {
    mean_weights(elements, weights, e, share);
    const Eigen::Matrix3d R =
        by_vector ? exponential_sum(rotations, share) : normalized_sum(quaternions, share, e);
    for (int column = 0; column < dim; ++column)
      for (int row = 0; row < dim; ++row) result.push_back(R(row, column));
  }
  return result;
}

}  // namespace isostretch::handles
