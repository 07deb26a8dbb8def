#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/handles/bounded_weights.hpp>
#include <isostretch/handles/motion.hpp>

#include <vector>

namespace isostretch::handles {

/// How rotations are mixed by weights that sum to 1.
///
/// angle: the weighted sum of angles, full turns included. In 3D all turns must have one axis up to its sign;
///   turns by 0 degrees have any.
/// quaternion: the normalised weighted sum of unit quaternions (complex numbers of half the angle in 2D), as
///   they come: 270 degrees stay 270, angles count modulo 720.
/// aligned_quaternion: the same with quaternions that point away from that of handle 0 turned to its side. A
///   turn by 270 degrees beside one by 0 becomes one by -90. Always the same handle, so that neighbouring
///   elements agree.
/// rotation_vector: the exponential of the weighted sum of axis * angle, full turns included; `angle` where
///   the axis is common.
enum class RotationBlend { angle, quaternion, aligned_quaternion, rotation_vector };

/// angle in 2D, quaternion in 3D.
RotationBlend default_blend(int dim);

/// One rotation for every element, dim x dim column by column, of determinant 1, by the mean of the weights
/// of its nodes. One turn a handle. Throws Error for elements that are invalid, sizes that do not fit, a turn
/// that is not finite or, in 3D, whose axis has length zero, axes that differ (angle), and an element whose
/// quaternions cancel to a sum shorter than 1e-8.
std::vector<double> blended_rotations(const assembly::Elements& elements, const HandleWeights& weights,
                                      const std::vector<Turn>& turns, RotationBlend blend);

}  // namespace isostretch::handles
