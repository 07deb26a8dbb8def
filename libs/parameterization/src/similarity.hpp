#pragma once

#include <Eigen/Core>

#include <vector>

namespace isostretch::parameterization {

// p -> scale_rotation * p + shift: keeps angles and orientation, so it turns no triangle over.
struct Similarity {
  Eigen::Matrix2d scale_rotation = Eigen::Matrix2d::Identity();
  Eigen::Vector2d shift{0, 0};

  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const { return scale_rotation * p + shift; }
};

// The one that brings `from` nearest to `to` in the least-squares sense; exact for one and two points. Only
// translates where the points leave rotation and scale open or ask for scale zero.
Similarity best_similarity(const std::vector<Eigen::Vector2d>& from, const std::vector<Eigen::Vector2d>& to);

}  // namespace isostretch::parameterization
