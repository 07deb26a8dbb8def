#include <isostretch/figures/distortion_scale.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isostretch::figures {
namespace {

// The value that all but a given share of the area stay below.
double quantile(const std::vector<double>& values, const std::vector<double>& areas, double share) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto i, auto j) { return values[i] < values[j]; });
  const double wanted = share * std::accumulate(areas.begin(), areas.end(), 0.0);
  double sum = 0;
  for (const std::size_t i : order) {
    sum += areas[i];
    if (sum >= wanted) return values[i];
  }
  return order.empty() ? 0 : values[order.back()];
}

}  // namespace

double distortion(double sigma_1, double sigma_2) {
  const double a = sigma_1 * sigma_1, b = sigma_2 * sigma_2;
  return a + b + 1 / a + 1 / b;
}

DistortionScale distortion_scale(const std::vector<double>& distortions, const std::vector<double>& areas,
                                 int bins, double best) {
  DistortionScale scale;
  // Between one percent above the best, so that rounding is not shown in colours, and what a picture can
  // show.
  const double top = std::clamp(quantile(distortions, areas, 0.995), 1.01 * best, 1e8 * best);
  scale.axis = narrow_log_axis(best, top, 8);
  scale.shares.assign(static_cast<std::size_t>(bins), 0.0);
  const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
  for (std::size_t i = 0; i < distortions.size(); ++i) {
    const double position = std::clamp(scale.axis.position(distortions[i]), 0.0, 1.0);
    const int bin = std::min(static_cast<int>(position * bins), bins - 1);
    scale.shares[static_cast<std::size_t>(bin)] += areas[i] / total;
    scale.above = scale.above || distortions[i] > top;
  }
  return scale;
}

}  // namespace isostretch::figures
