#pragma once

#include <isostretch/figures/canvas.hpp>
#include <isostretch/figures/pose.hpp>

namespace isostretch::figures {

/// A point on the screen, x to the right and y down, and 1 / its distance, which is linear on the screen as
/// depth is not.
struct ScreenPoint {
  double x = 0;         ///< To the right.
  double y = 0;         ///< Down.
  double nearness = 0;  ///< 1 / distance.
};

/// A camera that looks from a fixed distance at the middle of a model. The model lies in the unit ball around
/// the origin, so that nothing is ever behind the camera.
class Camera {
 public:
  /// Places the camera, turned around the model to the right by `azimuth` and up by `elevation`, in degrees.
  Camera(const Pose& pose, double azimuth, double elevation);

  /// Returns the place of a point on the screen, in units of the camera's own.
  ScreenPoint operator()(const Eigen::RowVector3d& point) const;

  /// Returns the unit vector to the right of the screen.
  const Eigen::Vector3d& right() const { return right_; }
  /// Returns the unit vector up the screen.
  const Eigen::Vector3d& up() const { return up_; }
  const Eigen::Vector3d& back() const { return back_; }  ///< Returns the unit vector towards the viewer.

 private:
  Eigen::Vector3d right_, up_, back_;
};

/// Returns the box around a model on the screen.
Box bounds(const Camera& camera, const mesh::Points3& vertices);

}  // namespace isostretch::figures
