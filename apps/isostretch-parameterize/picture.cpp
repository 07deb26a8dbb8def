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

std::string subtitle(const Result& r) {
  const newton::Summary& s = r.solution.summary;
  const std::size_t charts = r.start.charts.size();
  return format("%lld triangles%s   ·   %s after %d iterations, %.3g s   ·   energy %.10g   ·   |gradient|∞ %.2e   ·   "
                "%zu flipped%s",
                static_cast<long long>(r.domain.open().triangles.rows()),
                charts > 1 ? (" in " + std::to_string(charts) + " charts").c_str() : "",
                std::string(newton::status_name(s.status)).c_str(), s.iterations, s.seconds.total, s.energy,
                s.gradient_inf_norm, r.layout.flipped.size(), r.layout.flipped.empty() ? "" : " (blue)");
}

}  // namespace

std::string draw_layout(const Result& r) {
  const std::vector<double> values = distortions(r.solution.stretches);
  const std::vector<int> pinned = r.solution.pins.nodes();
  return figures::draw_solve({.title = r.options.model.filename().string() + ", " + r.energy.name(),
                              .subtitle = subtitle(r),
                              .layout = {r.layout.uv, r.domain.open().triangles, values, r.layout.flipped, pinned},
                              .areas = r.start.rest.weights,
                              .trace = r.solution.summary.trace});
}

}  // namespace isostretch::app::parameterize
