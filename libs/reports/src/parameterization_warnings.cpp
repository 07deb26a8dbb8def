#include "parameterization_summary.hpp"

#include <isostretch/core/text.hpp>

#include <algorithm>
#include <limits>

namespace isostretch::reports {
namespace {

std::string turned_over(const Json& count) {
  return with_thousands(count) + (count == 1 ? " triangle is turned over" : " triangles are turned over");
}

std::size_t not_converged(const Json& charts) {
  return static_cast<std::size_t>(std::count_if(charts.begin(), charts.end(), [](const Json& chart) {
    return chart.contains("status") && !chart["status"].get<std::string>().starts_with("converged");
  }));
}

}  // namespace

std::vector<std::string> page_warnings(const Json& s) {
  std::vector<std::string> warnings;
  if (s.at("flipped") > 0) warnings.push_back(turned_over(s["flipped"]) + " in the layout.");
  const Json& overlap = s.at("layout").at("overlap");
  if (overlap.at("triangles") > 0)
    warnings.push_back(
        formatted("The layout lies on itself: %.2g %% of its area is under more than one triangle; ",
                  100 * overlap["share"].get<double>()) +
        with_thousands(overlap["triangles"]) + " triangles of " +
        with_thousands(static_cast<long long>(overlap["charts"].size())) +
        " charts, hatched in the picture.");
  if (s.at("initial_flipped") > 0) warnings.push_back(turned_over(s["initial_flipped"]) + " in the start.");
  if (!s.at("converged").get<bool>())
    warnings.push_back("The solve did not converge: " + s.at("message").get<std::string>() + ".");
  const std::size_t stopped = not_converged(s.at("charts"));
  if (stopped > 0 && s["charts"].size() > 1)
    warnings.push_back(formatted("%zu of %zu charts did not converge.", stopped, s["charts"].size()));
  const double bound = s.at("options").at("max_distortion");
  const Json& written = s.at("distortion").at("worst");  // null where it is infinite
  const double worst = written.is_number() ? written.get<double>() : std::numeric_limits<double>::infinity();
  if (bound > 0 && !(worst <= bound))
    warnings.push_back(
        formatted("The largest distortion is %.4g, more than the %.4g asked for.", worst, bound));
  return warnings;
}

}  // namespace isostretch::reports
