#include <isostretch/deformation/rigid_motion.hpp>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <cmath>

namespace isostretch::deformation {

namespace {

// Of fixed size: the decomposition of a dynamic one would take memory from the heap.
template <int Dim>
Rotation nearest_rotation(const Rotation& covariance) {
  using Matrix = Eigen::Matrix<double, Dim, Dim>;
  const Eigen::JacobiSVD<Matrix> svd(Matrix{covariance}, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(Dim - 1) *= -1;
  return u * svd.matrixV().transpose();
}

}  // namespace

Place centroid(const WeightedNodes& nodes, const Vector& positions, int dim) {
  Place sum = Place::Zero(dim);
  for (std::size_t i = 0; i < nodes.nodes.size(); ++i)
    sum += nodes.weights[i] * positions.segment(dim * nodes.nodes[i], dim);
  return sum;
}

Rotation best_rotation(const WeightedNodes& nodes, const Vector& from, const Vector& to, int dim) {
  const Place from_centroid = centroid(nodes, from, dim), to_centroid = centroid(nodes, to, dim);
  Rotation covariance = Rotation::Zero(dim, dim);
  for (std::size_t i = 0; i < nodes.nodes.size(); ++i) {
    const Place a = from.segment(dim * nodes.nodes[i], dim) - from_centroid;
    const Place b = to.segment(dim * nodes.nodes[i], dim) - to_centroid;
    covariance += nodes.weights[i] * b * a.transpose();
  }
  return dim == 2 ? nearest_rotation<2>(covariance) : nearest_rotation<3>(covariance);
}

Rotation share_of(const Rotation& rotation, double t) {
  if (rotation.rows() == 2) {
    const double angle = std::atan2(rotation(1, 0), rotation(0, 0));
    return Eigen::Rotation2Dd(t * angle).toRotationMatrix();
  }
  const Eigen::AngleAxisd whole(Eigen::Matrix3d{rotation});
  return Eigen::AngleAxisd(t * whole.angle(), whole.axis()).toRotationMatrix();
}

void move(const WeightedNodes& nodes, const Rotation& rotation, const Place& from, const Place& to,
          Vector& positions) {
  const Eigen::Index dim = from.size();
  for (const int node : nodes.nodes) {
    auto at = positions.segment(dim * node, dim);
    const Place arm = at - from;  // a product with the expression would take memory from the heap
    const Place moved = rotation * arm + to;
    at = moved;
  }
}

}  // namespace isostretch::deformation
