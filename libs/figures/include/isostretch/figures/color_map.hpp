#pragma once

namespace isostretch::figures {

/// A colour in sRGB, each component from 0 to 1.
struct Color {
  double r = 0;  ///< Red.
  double g = 0;  ///< Green.
  double b = 0;  ///< Blue.
};

/// Returns a colour from pale yellow (0) over red to dark violet (1): lightness falls steadily in OKLab
/// (Ottosson 2020), so that the order of values survives a grey print and colour-blind eyes. Values outside
/// are clamped.
Color distortion_color(double value);

/// Returns a colour for a value with a sign, from dark blue (-1) over nearly white (0) to dark red (1),
/// equally dark at both ends. Values outside are clamped.
Color diverging_color(double value);

/// The colour of elements that are turned over, outside every scale.
inline constexpr Color flipped_color{0.0, 0.75, 0.95};

}  // namespace isostretch::figures
