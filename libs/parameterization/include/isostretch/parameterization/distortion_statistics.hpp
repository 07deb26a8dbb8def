#pragma once

#include <vector>

namespace isostretch::parameterization {

/// Of the singular values sigma_1 >= |sigma_2| of all triangles' maps, weighted by rest area for the means.
struct DistortionStatistics {
  double min_sigma = 0, mean_sigma = 0, max_sigma = 0;
  double mean_area_ratio = 0;   ///< sigma_1 sigma_2: the area of the layout when the rest area is 1
  double mean_sigma_ratio = 0;  ///< sigma_1 / sigma_2, 1 where angles are kept
  double max_sigma_ratio = 0;
};

/// `stretches` holds sigma_1, sigma_2 triangle by triangle.
DistortionStatistics distortion_statistics(const std::vector<double>& stretches,
                                           const std::vector<double>& areas);

}  // namespace isostretch::parameterization
