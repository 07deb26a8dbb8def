#include <isostretch/core/text.hpp>
#include <isostretch/deformation/handle_misses.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isostretch::deformation {
namespace {

constexpr double large_share_of_size = 0.1, large_share_of_diagonal = 0.02, collapsed = 0.5, flat = 1e-3;

double size_of(const std::vector<handles::Point>& points) {
  handles::Point mean = handles::Point::Zero();
  for (const handles::Point& p : points) mean += p / static_cast<double>(points.size());
  double radius = 0;
  for (const handles::Point& p : points) radius = std::max(radius, (p - mean).norm());
  return points.size() > 1 ? 2 * radius : 0;
}

HandleMiss miss_of(const HandleSet& handle_set, const Handle& handle, double time, int dim,
                   const Vector& positions) {
  HandleMiss miss{handle.name, handle.soft.has_value(), handle.nodes.size()};
  std::vector<handles::Point> targets, reached;
  for (const int node : handle.nodes) {
    targets.push_back(handle_set.target(handle, node, time));
    reached.emplace_back(handles::Point::Zero());
    reached.back().head(dim) = positions.segment(dim * node, dim);
    const double distance = (reached.back() - targets.back()).norm();
    miss.mean += distance / static_cast<double>(handle.nodes.size());
    if (miss.farthest_node < 0 || distance > miss.largest) miss.largest = distance, miss.farthest_node = node;
  }
  miss.size = size_of(targets);
  miss.size_reached = size_of(reached);
  return miss;
}

bool is_large(const HandleMiss& miss, double diagonal) {
  return miss.share() > large_share_of_size || miss.largest > large_share_of_diagonal * diagonal;
}

std::string warning_text(const HandleMiss& miss) {
  std::string text = "handle '" + miss.name + formatted("' misses its targets by up to %.3g", miss.largest);
  if (miss.size > 0) text += formatted(" (%.0f %% of its size)", 100 * miss.share());
  text += formatted(", %.3g on average", miss.mean);
  if (miss.size > 0 && miss.size_reached < collapsed * miss.size)
    text += formatted("; it has shrunk to %.2g %% of its size", 100 * miss.size_reached / miss.size);
  return text;
}

}  // namespace

double HandleMiss::share() const {
  return size > 0 ? largest / size : std::numeric_limits<double>::quiet_NaN();
}

std::vector<HandleMiss> handle_misses(const HandleSet& handle_set, double time, int dim,
                                      const Vector& positions) {
  std::vector<HandleMiss> misses;
  for (const Handle& handle : handle_set.handles())
    if (!handle.nodes.empty()) misses.push_back(miss_of(handle_set, handle, time, dim, positions));
  return misses;
}

std::string largest_miss_text(const std::vector<HandleMiss>& misses, double diagonal) {
  constexpr double rounding = 1e-9;
  const auto worst =
      std::max_element(misses.begin(), misses.end(),
                       [](const HandleMiss& a, const HandleMiss& b) { return a.largest < b.largest; });
  if (worst == misses.end() || !(worst->largest > rounding * diagonal)) return {};
  std::string text = formatted("handles miss their targets by %.3g at most", worst->largest);
  if (worst->size > 0)
    text += formatted(" (%.2g %% of the size of '", 100 * worst->share()) + worst->name + "')";
  return text;
}

std::vector<std::string> miss_warnings(const std::vector<HandleMiss>& misses, double diagonal) {
  std::vector<std::string> warnings;
  for (const HandleMiss& miss : misses)
    if (is_large(miss, diagonal)) warnings.push_back(warning_text(miss));
  return warnings;
}

std::vector<int> nearly_flat_elements(const StrainField& strain) {
  std::vector<int> elements;
  for (std::size_t e = 0; e < strain.min_det.size(); ++e)
    if (strain.min_det[e] > 0 && strain.min_det[e] < flat) elements.push_back(static_cast<int>(e));
  std::sort(elements.begin(), elements.end(), [&](int a, int b) {
    return strain.min_det[static_cast<std::size_t>(a)] < strain.min_det[static_cast<std::size_t>(b)];
  });
  return elements;
}

std::string nearly_flat_text(const std::vector<int>& elements, const StrainField& strain,
                             const SolidModel& body) {
  if (elements.empty()) return {};
  return formatted(
             "%zu element(s) are all but flat (less than a thousandth of the volume at rest), most of all ",
             elements.size()) +
         body.element_text(elements.front()) +
         formatted(" with det F %.2g", strain.min_det[static_cast<std::size_t>(elements.front())]);
}

}  // namespace isostretch::deformation
