#include <isostretch/parameterization/distortion_statistics.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::parameterization {

DistortionStatistics distortion_statistics(const std::vector<double>& stretches,
                                           const std::vector<double>& areas) {
  DistortionStatistics s;
  s.min_sigma = HUGE_VAL;
  s.max_sigma = -HUGE_VAL;
  double total = 0;
  for (std::size_t t = 0; t < areas.size(); ++t) {
    const double a = stretches[2 * t], b = stretches[2 * t + 1], area = areas[t];
    s.min_sigma = std::min(s.min_sigma, b);
    s.max_sigma = std::max(s.max_sigma, a);
    s.mean_sigma += 0.5 * area * (a + b);
    s.mean_area_ratio += area * a * b;
    s.mean_sigma_ratio += area * (a / std::abs(b));
    s.max_sigma_ratio = std::max(s.max_sigma_ratio, a / std::abs(b));
    total += area;
  }
  s.mean_sigma /= total;
  s.mean_area_ratio /= total;
  s.mean_sigma_ratio /= total;
  return s;
}

}  // namespace isostretch::parameterization
