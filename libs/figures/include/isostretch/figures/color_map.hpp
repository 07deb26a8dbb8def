#pragma once

namespace isostretch::figures {

/// sRGB, each from 0 to 1.
struct Color {
  double r = 0, g = 0, b = 0;
};

/// From pale yellow (0) over red to dark violet (1): lightness falls steadily in OKLab (Ottosson 2020), so
/// that the order of values survives a grey print and colour-blind eyes. Values outside are clamped.
Color distortion_color(double value);

/// Of values with a sign, from dark blue (-1) over nearly white (0) to dark red (1), equally dark at both
/// ends. Values outside are clamped.
Color diverging_color(double value);

/// Outside the scale altogether: elements that are turned over.
inline constexpr Color flipped_color{0.0, 0.75, 0.95};

}  // namespace isostretch::figures
