#pragma once

#include <vector>

namespace isostretch::parameterization {

/// Statistics of the singular values sigma_1 >= |sigma_2| of all triangles' maps. Means are weighted by rest
/// area.
struct DistortionStatistics {
  double min_sigma = 0;         ///< Smallest sigma_2, negative where a triangle is turned over.
  double mean_sigma = 0;        ///< Mean of both singular values.
  double max_sigma = 0;         ///< Largest singular value.
  double mean_area_ratio = 0;   ///< Mean of sigma_1 sigma_2, the area of the layout when the rest area is 1.
  double mean_sigma_ratio = 0;  ///< Mean of sigma_1 / |sigma_2|, 1 where angles are kept.
  double max_sigma_ratio = 0;   ///< The largest sigma_1 / |sigma_2|.
};

/// Returns statistics of the distortion. `stretches` holds sigma_1, sigma_2 triangle by triangle, `areas` the
/// rest areas.
DistortionStatistics distortion_statistics(const std::vector<double>& stretches,
                                           const std::vector<double>& areas);

}  // namespace isostretch::parameterization
