#include <isostretch/core/error.hpp>
#include <isostretch/handles/motion.hpp>

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <string>

using namespace isostretch;
using namespace isostretch::handles;

namespace {

const Point x = Point::UnitX(), y = Point::UnitY(), z = Point::UnitZ();

Motion motion(const std::vector<Keyframe>& keys, const Point& center = Point::Zero()) {
  return {keys, center, "handle"};
}

void check_failure(const std::vector<Keyframe>& keys, const std::string& word) {
  std::string message = "nothing thrown";
  try {
    motion(keys);
  } catch (const Error& error) {
    message = error.what();
  }
  CAPTURE(message);
  CHECK(message.rfind("handle: ", 0) == 0);
  CHECK(message.find(word) != std::string::npos);
}

}  // namespace

TEST_CASE("quarter turns are exact, and full turns count between keyframes") {
  const Motion turn = motion({{0, {}}, {1, {.axis = z, .degrees = 720}}});
  CHECK(turn.at(1)(x) == x);
  CHECK(turn.at(0.5)(x) == x);
  CHECK(turn.at(0.125)(x) == y);
  CHECK(turn.at(0.25)(x) == Point(-x));
  CHECK((turn.at(0.0625)(x) - Point(std::sqrt(0.5), std::sqrt(0.5), 0)).norm() < 1e-15);
}

TEST_CASE("rotation and scale go about the centre, translation comes last") {
  const Point center(1, 1, 0);
  const Motion m =
      motion({{0, {.translation = {0, 0, 2}, .axis = 5 * z, .degrees = 90, .scale = 2}}}, center);
  CHECK((m.at(0)({2, 1, 0}) - Point(1, 3, 2)).norm() < 1e-15);
  CHECK((m.at(0)(center) - Point(1, 1, 2)).norm() < 1e-15);
}

TEST_CASE("linear in time between keyframes, at rest outside") {
  const Motion m = motion({{1, {.translation = x}}, {3, {.translation = 5 * x, .scale = 3}}});
  CHECK(m.at(-1).translation == x);
  CHECK(m.at(2).translation == Point(3 * x));
  CHECK((m.at(2).linear - 2 * Eigen::Matrix3d::Identity()).norm() < 1e-15);
  CHECK(m.at(9).translation == Point(5 * x));
}

TEST_CASE("opposite axes are one axis, a key without rotation has any") {
  const Motion opposite = motion({{0, {.axis = z, .degrees = 90}}, {1, {.axis = -2 * z, .degrees = 270}}});
  CHECK(opposite.at(0.25)(x) == x);  // from 90 down to -270
  const Motion from_rest = motion({{0, {.axis = x}}, {1, {.axis = y, .degrees = 400}}});
  CHECK((from_rest.at(0.225)(x) + z).norm() < 1e-14);
  const Motion to_rest = motion({{0, {.axis = y, .degrees = 400}}, {1, {.axis = x}}});
  CHECK((to_rest.at(0.775)(x) + z).norm() < 1e-14);
}

TEST_CASE("between different axes the rotation goes the shortest way, evenly") {
  const Motion m = motion({{0, {.axis = z, .degrees = 90}}, {1, {.axis = x, .degrees = 90}}});
  const auto rotation = [&](double t) { return m.at(t).linear; };
  const double whole = Eigen::AngleAxisd(rotation(0).transpose() * rotation(1)).angle();
  for (const double t : {0.25, 0.5, 0.75}) {
    CHECK((rotation(t).transpose() * rotation(t) - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    CHECK(Eigen::AngleAxisd(rotation(0).transpose() * rotation(t)).angle() == doctest::Approx(t * whole));
  }
  CHECK((rotation(0) * x - y).norm() < 1e-15);
  CHECK((rotation(1) * y - z).norm() < 1e-15);
}

TEST_CASE("turns keep their windings where the axis stays, and say what placements do") {
  const Motion far =
      motion({{0, {}}, {1, {.axis = 3 * x, .degrees = 720}}, {2, {.axis = -x, .degrees = 90}}});
  CHECK(far.axis_angle(-1).degrees == 0);
  CHECK(far.axis_angle(0.75).degrees == 540);
  CHECK(far.axis_angle(0.75).axis == x);
  CHECK(far.axis_angle(1.5).degrees == doctest::Approx(315));
  CHECK(far.axis_angle(9).degrees == 90);
  CHECK(motion({{0, {.axis = -2 * z, .degrees = 270}}}).axis_angle(0).degrees == -270);
  CHECK(motion({{0, {.axis = -2 * z, .degrees = 270}}}).axis_angle(0).axis == z);
  const Motion mixed = motion({{0, {.axis = z, .degrees = 90}}, {1, {.axis = x, .degrees = 90}}});
  for (const Motion& m : {far, mixed})
    for (const double t : {-1.0, 0.0, 0.3, 0.8, 1.0, 1.7, 3.0}) {
      const AxisAngle given = m.axis_angle(t);
      CHECK(given.axis.norm() == doctest::Approx(1));
      const Eigen::AngleAxisd rotation(given.degrees * std::acos(-1.0) / 180, given.axis);
      CHECK((rotation.toRotationMatrix() - m.at(t).linear).norm() < 1e-13);
    }
}

TEST_CASE("axes may be of any length") {
  for (const double length : {1e200, 1e-200, 1e308, 5e-324}) {
    CHECK(motion({{0, {.axis = length * z, .degrees = 90}}}).at(0)(x) == y);
    const Point diagonal = Point::Constant(length);
    CHECK((motion({{0, {.axis = diagonal, .degrees = 120}}}).at(0)(x) - y).norm() < 1e-14);
    const Motion m = motion({{0, {.axis = z}}, {1, {.axis = length * z, .degrees = 720}}});
    CHECK(m.at(0.125)(x) == y);
  }
}

TEST_CASE("motions that make no sense are errors that begin with the name") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  check_failure({}, "no keyframes");
  check_failure({{1, {}}, {1, {}}}, "keyframe 1");
  check_failure({{0, {.axis = Point::Zero(), .degrees = 1}}}, "axis");
  check_failure({{0, {.scale = 0}}}, "scale");
  check_failure({{0, {.degrees = nan}}}, "not finite");
  CHECK_THROWS_AS(motion({{0, {}}}, {nan, 0, 0}), Error);
}

TEST_CASE("the centre of a handle is the mean of its nodes") {
  Nodes nodes;
  nodes.dim = 2;
  nodes.positions.resize(6);
  nodes.positions << 0, 0, 2, 0, 9, 9;
  CHECK(center_of({0, 1}, nodes) == x);
}
