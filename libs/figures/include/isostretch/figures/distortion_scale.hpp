#pragma once

#include <isostretch/figures/axis.hpp>

#include <vector>

namespace isostretch::figures {

/// Distortion |J|^2 + |J^-1|^2 of a triangle from its singular values: 4 where lengths are kept, infinite
/// where the triangle has collapsed. A negative sigma_2 (turned over) counts by its size.
double distortion(double sigma_1, double sigma_2);

/// The logarithmic axis that colours and histogram share, and the histogram.
struct DistortionScale {
  Axis axis;
  std::vector<double> shares;  ///< of the area, per bin from axis.low to axis.high; the last takes all above
  bool above = false;          ///< some lie above axis.high

  double color_value(double d) const { return axis.position(d); }
};

/// `areas` are the triangles' shares in the rest area. The top of the scale leaves out the worst half
/// percent, which would otherwise squeeze all others into one colour. `best` is the least a measure can be.
DistortionScale distortion_scale(const std::vector<double>& distortions, const std::vector<double>& areas,
                                 int bins, double best = 4);

}  // namespace isostretch::figures
