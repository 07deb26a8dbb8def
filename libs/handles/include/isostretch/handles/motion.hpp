#pragma once

#include <isostretch/handles/selection.hpp>

#include <optional>
#include <string>
#include <vector>

namespace isostretch::handles {

/// A rotation by `degrees` about an axis through a centre, a scaling about the centre, and then a
/// translation.
struct Transform {
  Point translation = Point::Zero();  ///< Translation, in the units of positions.
  Point axis = Point::UnitZ();        ///< Axis of rotation, of any length but zero.
  double degrees = 0;                 ///< Angle of rotation; more than a full turn counts.
  double scale = 1;                   ///< Factor of lengths.
};

/// A transform at a time.
struct Keyframe {
  double time = 0;      ///< Time, in the units of the motion.
  Transform transform;  ///< Transform from the rest position.
};

/// A rotation about an axis that counts full turns.
struct AxisAngle {
  Point axis = Point::UnitZ();  ///< Axis of rotation, of any length but zero; ignored in 2D.
  double degrees = 0;           ///< Angle of rotation; more than a full turn counts.
};

/// A transform at one time as an affine map.
struct Placement {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();  ///< Rotation times scale.
  Point center = Point::Zero();                          ///< Centre of rotation and scaling.
  Point translation = Point::Zero();                     ///< Translation.

  /// Returns the position of a point that is at `rest` at rest.
  Point operator()(const Point& rest) const { return linear * (rest - center) + center + translation; }
};

/// The motion of a handle by keyframes. Between them translation and scale are linear in time, and so is the
/// angle as long as the axis stays (opposite axes are the same axis). Where the axis changes, the rotation
/// goes the shortest way on the great arc (slerp), and full turns do not count. Before the first and
/// after the last keyframe the handle rests.
class Motion {
 public:
  /// Makes a motion about a centre. Throws Error, beginning with `name`, without keyframes, for times that do
  /// not ascend, an axis of length zero, a scale that is not positive, and numbers that are not finite.
  Motion(std::vector<Keyframe> keyframes, const Point& center, const std::string& name);

  /// Returns the transform at a time.
  Placement at(double time) const;

  /// Returns the rotation of at(time), with its full turns where the axis stays; between keyframes whose axes
  /// differ, by 180 degrees at most. The axis has length one, and is z rather than -z, so that degrees count
  /// counter-clockwise in 2D.
  AxisAngle axis_angle(double time) const;

  /// Returns the keyframes.
  const std::vector<Keyframe>& keyframes() const { return keyframes_; }

 private:
  std::vector<Keyframe> keyframes_;
  Point center_;
};

/// Returns the mean of the chosen nodes at rest, the centre of a handle without another.
Point center_of(const std::vector<int>& chosen, const Nodes& nodes);

}  // namespace isostretch::handles
