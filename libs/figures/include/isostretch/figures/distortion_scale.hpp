#pragma once

#include <isostretch/figures/axis.hpp>

#include <vector>

namespace isostretch::figures {

/// Returns the distortion |J|^2 + |J^-1|^2 of a triangle from its singular values: 4 where lengths are kept,
/// infinity where the triangle has collapsed. A negative sigma_2 (turned over) counts by its size.
double distortion(double sigma_1, double sigma_2);

/// The logarithmic axis that colours and histogram share, and the histogram.
struct DistortionScale {
  Axis axis;  ///< Range of the measure.
  /// Shares of the area, per bin from axis.low to axis.high; the last takes all above.
  std::vector<double> shares;
  bool above = false;  ///< Whether some lie above axis.high.

  /// Returns the value of distortion_color() for a measure.
  double color_value(double d) const { return axis.position(d); }
};

/// Returns the scale of a measure of triangles. `areas` are their shares in the rest area, `best` is the
/// least value that the measure can have. The top of the scale leaves out the worst half percent, which would
/// otherwise squeeze all others into one colour.
DistortionScale distortion_scale(const std::vector<double>& distortions, const std::vector<double>& areas,
                                 int bins, double best = 4);

}  // namespace isostretch::figures
