#include <isostretch/core/error.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/handles/motion.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace isostretch::handles {
namespace {

using Rotation = Eigen::Matrix3d;

// Of an axis of any length: its square may overflow or vanish.
Point unit(const Point& axis) {
  return (axis / axis.cwiseAbs().maxCoeff()).normalized();
}

Rotation rotation(const Point& axis, double degrees) {
  // Full axis_angles are taken off first, and quarter axis_angles are exact.
  const double turn = std::remainder(degrees, 360.0);
  double s = std::sin(turn * std::numbers::pi / 180), c = std::cos(turn * std::numbers::pi / 180);
  if (std::fmod(turn, 90.0) == 0) s = std::round(s), c = std::round(c);
  const Point n = unit(axis);
  Rotation cross;
  cross << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
  return Rotation::Identity() + s * cross + (1 - c) * cross * cross;
}

double mix(double from, double to, double t) {
  return from + t * (to - from);
}

void require_finite(const Keyframe& key, const std::string& name) {
  const Transform& t = key.transform;
  if (!(std::isfinite(key.time) && t.translation.allFinite() && t.axis.allFinite() &&
        std::isfinite(t.degrees) && std::isfinite(t.scale)))
    throw Error(name + ": a number that is not finite");
  if (t.axis.isZero(0)) throw Error(name + ": a rotation axis of length zero");
  if (!(t.scale > 0)) throw Error(name + ": a scale of " + to_text(t.scale) + ", must be positive");
}

// Degrees about the axis of `a` that `b` stands for, if it has the same axis.
bool shares_axis(const Transform& a, const Transform& b, double& degrees) {
  constexpr double same = 1e-12;
  const Point m = unit(a.axis), n = unit(b.axis);
  const bool parallel = m.cross(n).norm() <= same;
  degrees = m.dot(n) < 0 ? -b.degrees : b.degrees;
  return parallel || b.degrees == 0;
}

// Between transforms of one axis.
std::optional<AxisAngle> rotation_between(const Transform& a, const Transform& b, double t) {
  double degrees = 0;
  if (shares_axis(a, b, degrees)) return AxisAngle{a.axis, mix(a.degrees, degrees, t)};
  if (shares_axis(b, a, degrees)) return AxisAngle{b.axis, mix(degrees, b.degrees, t)};
  return std::nullopt;
}

Rotation between(const Transform& a, const Transform& b, double t) {
  if (const auto between = rotation_between(a, b, t)) return rotation(between->axis, between->degrees);
  const Rotation from = rotation(a.axis, a.degrees);
  const Eigen::AngleAxisd way(Rotation(from.transpose() * rotation(b.axis, b.degrees)));
  return from * rotation(way.axis(), t * way.angle() * 180 / std::numbers::pi);
}

AxisAngle counter_clockwise(const AxisAngle& given) {
  const Point axis = unit(given.axis);
  return axis.z() == -1 ? AxisAngle{-axis, -given.degrees} : AxisAngle{axis, given.degrees};
}

}  // namespace

Motion::Motion(std::vector<Keyframe> keyframes, const Point& center, const std::string& name)
    : keyframes_(std::move(keyframes)), center_(center) {
  if (keyframes_.empty()) throw Error(name + ": no keyframes");
  for (const Keyframe& key : keyframes_) require_finite(key, name);
  if (!center_.allFinite()) throw Error(name + ": a centre that is not finite");
  for (std::size_t i = 1; i < keyframes_.size(); ++i)
    if (!(keyframes_[i - 1].time < keyframes_[i].time))
      throw Error(name + ": keyframe " + std::to_string(i) + " is not later than the one before");
}

Placement Motion::at(double time) const {
  const auto after = std::find_if(keyframes_.begin(), keyframes_.end(),
                                  [&](const Keyframe& key) { return key.time > time; });
  const auto placed = [&](const Rotation& turned, double scale, const Point& translation) {
    return Placement{scale * turned, center_, translation};
  };
  if (after == keyframes_.begin() || after == keyframes_.end()) {
    const Transform& key = (after == keyframes_.end() ? keyframes_.back() : *after).transform;
    return placed(rotation(key.axis, key.degrees), key.scale, key.translation);
  }
  const Transform &a = (after - 1)->transform, &b = after->transform;
  const double t = (time - (after - 1)->time) / (after->time - (after - 1)->time);
  return placed(between(a, b, t), mix(a.scale, b.scale, t),
                a.translation + t * (b.translation - a.translation));
}

AxisAngle Motion::axis_angle(double time) const {
  const auto after = std::find_if(keyframes_.begin(), keyframes_.end(),
                                  [&](const Keyframe& key) { return key.time > time; });
  if (after == keyframes_.begin() || after == keyframes_.end()) {
    const Transform& key = (after == keyframes_.end() ? keyframes_.back() : *after).transform;
    return counter_clockwise({key.axis, key.degrees});
  }
  const Transform &a = (after - 1)->transform, &b = after->transform;
  const double t = (time - (after - 1)->time) / (after->time - (after - 1)->time);
  if (const auto between = rotation_between(a, b, t)) return counter_clockwise(*between);
  const Eigen::AngleAxisd whole(between(a, b, t));
  return counter_clockwise({whole.axis(), whole.angle() * 180 / std::numbers::pi});
}

Point center_of(const std::vector<int>& chosen, const Nodes& nodes) {
  Point sum = Point::Zero();
  for (const int node : chosen) sum += nodes.at(node);
  return sum / static_cast<double>(chosen.size());
}

}  // namespace isostretch::handles
