#pragma once

#include <isostretch/figures/canvas.hpp>
#include <isostretch/figures/pose.hpp>

namespace isostretch::figures {

/// A point on the screen, x to the right and y down, and 1 / its distance, which is linear on the screen as
/// depth is not.
struct ScreenPoint {
  double x = 0, y = 0, nearness = 0;
};

/// Looks from a fixed distance at the middle of a model that lies in the unit ball around the origin, so that
/// nothing is ever behind it.
class Camera {
 public:
  /// Turned around the model to the right by `azimuth` and up by `elevation`, in degrees.
  Camera(const Pose& pose, double azimuth, double elevation);

  /// In units of its own.
  ScreenPoint operator()(const Eigen::RowVector3d& point) const;

  const Eigen::Vector3d& right() const { return right_; }
  const Eigen::Vector3d& up() const { return up_; }
  const Eigen::Vector3d& back() const { return back_; }  // towards the viewer

 private:
  Eigen::Vector3d right_, up_, back_;
};

/// The box around a model on the screen.
Box bounds(const Camera& camera, const mesh::Points3& vertices);

}  // namespace isostretch::figures
