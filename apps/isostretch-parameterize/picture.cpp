#include "common/figures/solve_figure.hpp"
#include "report.hpp"

#include <cstdio>

namespace isostretch::app::parameterize {
namespace {

template <class... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  char text[256];
  std::snprintf(text, sizeof text, pattern, arguments...);
  return text;
}

std::vector<double> distortions(const std::vector<double>& stretches) {
  std::vector<double> values;
  for (std::size_t i = 0; i + 1 < stretches.size(); i += 2)
    values.push_back(figures::distortion(stretches[i], stretches[i + 1]));
  return values;
}

std::string subtitle(const Domain& domain, const Solution& solution) {
  const newton::Summary& s = solution.summary;
  return format(
      "%lld triangles   ·   %s after %d iterations, %.3g s   ·   energy %.10g   ·   "
      "|gradient|∞ %.2e   ·   %zu flipped%s",
      static_cast<long long>(domain.open.triangles.rows()),
      std::string(newton::status_name(s.status)).c_str(), s.iterations, s.seconds.total, s.energy,
      s.gradient_inf_norm, solution.flipped.size(), solution.flipped.empty() ? "" : " (blue)");
}

}  // namespace

std::string draw(const Domain& domain, const Start& start, const energies::AnyEnergy& energy,
                 const Solution& solution, const Options& options) {
  const std::vector<double> values = distortions(solution.stretches);
  return figures::draw_solve(
      {.title = options.model.filename().string() + ", " + energy.name(),
       .subtitle = subtitle(domain, solution),
       .layout = {solution.uv, domain.open.triangles, values, solution.flipped, solution.pinned},
       .areas = start.elements.weights,
       .trace = solution.summary.trace});
}

}  // namespace isostretch::app::parameterize
