#pragma once

#include <isostretch/figures/color_map.hpp>

#include <string>

namespace isostretch::figures {

/// The colour of light squares: muted, and far in hue from flipped_color.
inline constexpr Color checker_light{0.94, 0.92, 0.87};
/// The colour of dark squares: muted, and far in hue from flipped_color.
inline constexpr Color checker_dark{0.71, 0.48, 0.38};

/// Returns the colour at a point of the unbounded board whose squares have side 1; a point that is not finite
/// is on a light one.
Color checker_color(double u, double v);

/// The number of cells along each side of checker_texture(); even, so that it repeats without a fault.
inline constexpr int texture_cells = 8;

/// Returns the board as a PNG of 1024 x 1024 pixels. Every cell bears its column (A to H, by u) and row (1 to
/// 8, by v), by which one sees how a layout is turned and that it is not mirrored.
std::string checker_texture();

}  // namespace isostretch::figures
