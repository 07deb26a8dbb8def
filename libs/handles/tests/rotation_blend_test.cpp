#include <isostretch/core/error.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/handles/rotation_blend.hpp>
#include <isostretch/mesh/generators.hpp>

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

using namespace isostretch;
using namespace isostretch::handles;

namespace {

const Point x = Point::UnitX(), y = Point::UnitY(), z = Point::UnitZ();

assembly::Elements square() {
  const auto m = mesh::grid(1, 1);
  const mesh::Points2 flat = m.vertices.leftCols<2>();
  return assembly::elements_from(mesh::elements(flat, m.triangles));
}

assembly::Elements cube() {
  return assembly::elements_from(mesh::elements(mesh::tet_bar(1, 1, 1)));
}

// The same share of every handle at every node.
HandleWeights everywhere(const assembly::Elements& elements, const std::vector<double>& share) {
  HandleWeights weights;
  weights.handles = static_cast<int>(share.size());
  for (int n = 0; n < elements.node_count; ++n)
    weights.values.insert(weights.values.end(), share.begin(), share.end());
  return weights;
}

// Of the first element in 2D, in degrees from -180 to 180.
double angle(const std::vector<double>& shares, const std::vector<AxisAngle>& axis_angles,
             RotationBlend blend) {
  const auto R = blended_rotations(square(), everywhere(square(), shares), axis_angles, blend);
  CHECK(R.size() == 8);
  CHECK(R[0] * R[3] - R[1] * R[2] == doctest::Approx(1).epsilon(1e-14));
  return std::atan2(R[1], R[0]) * 180 / std::numbers::pi;
}

Eigen::Matrix3d rotation(const std::vector<double>& shares, const std::vector<AxisAngle>& axis_angles,
                         RotationBlend blend) {
  const auto R = blended_rotations(cube(), everywhere(cube(), shares), axis_angles, blend);
  REQUIRE(R.size() == 54);
  const Eigen::Matrix3d first = Eigen::Map<const Eigen::Matrix3d>(R.data());
  CHECK((first.transpose() * first - Eigen::Matrix3d::Identity()).norm() < 1e-14);
  CHECK(first.determinant() > 0);
  return first;
}

}  // namespace

TEST_CASE("in the plane angles add up with their windings") {
  for (const RotationBlend blend : {RotationBlend::angle, RotationBlend::rotation_vector}) {
    CHECK(angle({0.25, 0.75}, {{}, {z, 100}}, blend) == doctest::Approx(75));
    CHECK(angle({0.5, 0.5}, {{}, {z, 270}}, blend) == doctest::Approx(135));
    CHECK(angle({0.5, 0.5}, {{}, {z, 1000}}, blend) == doctest::Approx(140));
    CHECK(angle({0.5, 0.5}, {{}, {x, 90}}, blend) == doctest::Approx(45));  // the axis is not looked at
  }
}

TEST_CASE("quaternions keep 270 degrees, aligned ones make them -90") {
  CHECK(angle({0.5, 0.5}, {{}, {z, 270}}, RotationBlend::quaternion) == doctest::Approx(135));
  CHECK(angle({0.5, 0.5}, {{}, {z, 270}}, RotationBlend::aligned_quaternion) == doctest::Approx(-45));
  CHECK(angle({0.5, 0.5}, {{z, 270}, {}}, RotationBlend::aligned_quaternion) == doctest::Approx(-45));
  CHECK(angle({0.5, 0.5}, {{}, {z, 90}}, RotationBlend::aligned_quaternion) == doctest::Approx(45));
  CHECK(angle({0.3, 0.7}, {{}, {z, 90 + 720}}, RotationBlend::quaternion) ==
        doctest::Approx(angle({0.3, 0.7}, {{}, {z, 90}}, RotationBlend::quaternion)));
}

TEST_CASE("in space about one axis all blends are those of the plane") {
  const Point axis = Point(1, 2, -2);
  const auto about = [&](double degrees) {
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()).toRotationMatrix();
  };
  const std::vector<AxisAngle> axis_angles{{axis, 0}, {-axis, -270}};
  for (const RotationBlend blend :
       {RotationBlend::angle, RotationBlend::quaternion, RotationBlend::rotation_vector})
    CHECK((rotation({0.5, 0.5}, axis_angles, blend) - about(135)).norm() < 1e-14);
  CHECK((rotation({0.5, 0.5}, axis_angles, RotationBlend::aligned_quaternion) - about(-45)).norm() < 1e-14);
  CHECK((rotation({0.5, 0.5}, {{x, 0}, {axis, 90}}, RotationBlend::angle) - about(45)).norm() < 1e-14);
  CHECK((rotation({0.2, 0.8}, {{axis, 100}, {axis, 1000}}, RotationBlend::angle) - about(820)).norm() <
        1e-13);
}

TEST_CASE("a handle that has all the weight gives its own rotation") {
  const std::vector<AxisAngle> axis_angles{{x, 90}, {y, 200}, {z, -30}};
  for (const RotationBlend blend :
       {RotationBlend::quaternion, RotationBlend::aligned_quaternion, RotationBlend::rotation_vector}) {
    const Eigen::Matrix3d R = rotation({0, 1, 0}, axis_angles, blend);
    CHECK((R - Eigen::AngleAxisd(200 * std::numbers::pi / 180, y).toRotationMatrix()).norm() < 1e-14);
  }
}

TEST_CASE("an element takes the mean of its nodes") {
  HandleWeights weights = everywhere(square(), {1, 0});
  weights.values[2 * 1] = 0, weights.values[2 * 1 + 1] = 1;  // a corner of the first triangle alone
  const auto R = blended_rotations(square(), weights, {{}, {z, 90}}, RotationBlend::angle);
  CHECK(std::atan2(R[1], R[0]) == doctest::Approx(std::numbers::pi / 6));
  CHECK(R[4] == 1);
}

TEST_CASE("blends that make no sense are errors") {
  const HandleWeights half = everywhere(square(), {0.5, 0.5}), in_space = everywhere(cube(), {0.5, 0.5});
  const auto flat = [&](const std::vector<AxisAngle>& axis_angles,
                        RotationBlend blend = RotationBlend::quaternion) {
    blended_rotations(square(), half, axis_angles, blend);
  };
  const auto solid = [&](const std::vector<AxisAngle>& axis_angles, RotationBlend blend) {
    blended_rotations(cube(), in_space, axis_angles, blend);
  };
  CHECK_THROWS_WITH_AS(flat({{}, {z, 360}}), doctest::Contains("element 0"), Error);
  CHECK_THROWS_WITH_AS(flat({{}}), doctest::Contains("1 turns"), Error);
  CHECK_THROWS_WITH_AS(flat({{}, {z, std::numeric_limits<double>::infinity()}}),
                       doctest::Contains("handle 1 is not finite"), Error);
  CHECK_THROWS_WITH_AS(solid({{x, 90}, {y, 90}}, RotationBlend::angle),
                       doctest::Contains("handle 1 has another"), Error);
  CHECK_THROWS_WITH_AS(solid({{x, 90}, {Point::Zero(), 0}}, RotationBlend::quaternion),
                       doctest::Contains("handle 1 has an axis of length zero"), Error);
  HandleWeights short_one = half;
  short_one.values.pop_back();
  CHECK_THROWS_WITH_AS(blended_rotations(square(), short_one, {{}, {}}, RotationBlend::angle),
                       doctest::Contains("7 weights"), Error);
}

TEST_CASE("the blend that goes without saying is by angles in 2D, by quaternions in 3D") {
  CHECK(default_blend(2) == RotationBlend::angle);
  CHECK(default_blend(3) == RotationBlend::quaternion);
}
