#pragma once

#include <isostretch/handles/selection.hpp>

#include <optional>
#include <string>
#include <vector>

namespace isostretch::handles {

/// Rotated by `degrees` about an axis through the centre, scaled about the centre, then translated.
struct Transform {
  Point translation = Point::Zero();
  Point axis = Point::UnitZ();  ///< of any length but zero
  double degrees = 0;           ///< more than a full turn counts
  double scale = 1;
};

struct Keyframe {
  double time = 0;
  Transform transform;
};

/// A rotation that knows how often it went round.
struct Turn {
  Point axis = Point::UnitZ();  ///< of any length but zero; not looked at in 2D
  double degrees = 0;           ///< more than a full turn counts
};

/// A transform at one time, ready to be applied.
struct Placement {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();  ///< scaled rotation
  Point center = Point::Zero();
  Point translation = Point::Zero();

  Point operator()(const Point& rest) const { return linear * (rest - center) + center + translation; }
};

/// How a handle moves. Between keyframes translation and scale are linear in time, and so is the angle as
/// long as the axis stays (opposite axes are the same axis). Where it changes, the rotation goes the shortest
/// way on the great arc (slerp), and full turns do not count. Before the first and after the last keyframe it
/// rests.
class Motion {
 public:
  /// Throws Error, beginning with `name`, without keyframes, for times that do not ascend, an axis of length
  /// zero, a scale that is not positive, and numbers that are not finite.
  Motion(std::vector<Keyframe> keyframes, const Point& center, const std::string& name);

  Placement at(double time) const;

  /// The rotation of at(time) with its full turns where the axis stays; between keyframes whose axes differ,
  /// by 180 degrees at most. The axis has length one, and is z rather than -z, so that degrees count
  /// counter-clockwise in 2D.
  Turn turn(double time) const;

  const std::vector<Keyframe>& keyframes() const { return keyframes_; }

 private:
  std::vector<Keyframe> keyframes_;
  Point center_;
};

/// The centre of a handle that says none: the mean of its nodes at rest.
Point center_of(const std::vector<int>& chosen, const Nodes& nodes);

}  // namespace isostretch::handles
