#include <isostretch/figures/camera.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isostretch::figures {
namespace {

constexpr double distance = 4;  // an angle of view of 29 degrees at most

}  // namespace

Camera::Camera(const Pose& pose, double azimuth, double elevation) {
  const double a = azimuth * std::numbers::pi / 180, e = elevation * std::numbers::pi / 180;
  const Eigen::Vector3d around = std::cos(a) * pose.front + std::sin(a) * pose.right();
  right_ = std::cos(a) * pose.right() - std::sin(a) * pose.front;
  back_ = std::cos(e) * around + std::sin(e) * pose.up;
  up_ = back_.cross(right_);
}

ScreenPoint Camera::operator()(const Eigen::RowVector3d& point) const {
  const double nearness = 1 / (distance - point.dot(back_));
  return {point.dot(right_) * nearness, -point.dot(up_) * nearness, nearness};
}

Box bounds(const Camera& camera, const mesh::Points3& vertices) {
  Point low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
  for (Eigen::Index v = 0; v < vertices.rows(); ++v) {
    const ScreenPoint p = camera(vertices.row(v));
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return {low.x, low.y, high.x - low.x, high.y - low.y};
}

}  // namespace isostretch::figures
