#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/core/choice_names.hpp>
#include <isostretch/handles/bounded_weights.hpp>
#include <isostretch/handles/motion.hpp>

#include <vector>

namespace isostretch::handles {

/// The ways of mixing rotations by weights that sum to 1.
enum class RotationBlend {
  /// The weighted sum of angles, full turns included. In 3D all rotations must have one axis up to its
  /// sign; those by 0 degrees have any.
  angle,
  /// The normalised weighted sum of unit quaternions (complex numbers of half the angle in 2D), as they come:
  /// 270 degrees stay 270, and angles count modulo 720.
  quaternion,
  /// The normalised weighted sum of unit quaternions, of which those that point away from that of handle 0
  /// are turned to its side. A rotation by 270 degrees beside one by 0 becomes one by -90. It is always the
  /// same handle, so that neighbouring elements agree.
  aligned_quaternion,
  /// The exponential of the weighted sum of axis * angle, full turns included; `angle` where the axis
  /// is common.
  rotation_vector,
};
/// Returns the names of the ways of mixing rotations.
constexpr ChoiceNames<RotationBlend, 4> choice_names(RotationBlend) {
  return {{{"angle", RotationBlend::angle},
           {"quaternion", RotationBlend::quaternion},
           {"aligned_quaternion", RotationBlend::aligned_quaternion},
           {"rotation_vector", RotationBlend::rotation_vector}}};
}

/// Returns the default way of mixing rotations in dimension `dim`: angle in 2D, quaternion in 3D.
RotationBlend default_blend(int dim);

/// Returns one rotation for every element, dim x dim column by column, of determinant 1, by the mean of the
/// weights of its nodes. `axis_angles` has a rotation per handle. Throws Error for elements that are invalid,
/// sizes that do not fit, a rotation that is not finite or, in 3D, whose axis has length zero, axes that
/// differ (with RotationBlend::angle), and an element whose quaternions cancel to a sum shorter than 1e-8.
std::vector<double> blended_rotations(const assembly::Elements& elements, const HandleWeights& weights,
                                      const std::vector<AxisAngle>& axis_angles, RotationBlend blend);

}  // namespace isostretch::handles
