#include <isostretch/reports/parameterization_report.hpp>

#include <isostretch/core/text.hpp>
#include <isostretch/figures/parameterization_figures.hpp>

#include <cmath>

namespace isostretch::reports {
namespace {

using Result = ParameterizationReport;

std::string flips_text(const Result& r) {
  const std::size_t flipped = r.result.layout.flipped.size();
  if (flipped == 0) return "no triangle is turned over";
  return counted(flipped, "triangle") + (flipped == 1 ? " is" : " are") + " turned over";
}

std::string overlap_text(const Result& r) {
  const mesh::Overlap& overlap = r.result.layout.overlap;
  if (overlap.triangles.empty()) return "nothing overlaps";
  return figures::share_text(overlap.share()) + " of the layout's area lies under more than one triangle";
}

std::string stretch_text(const Result& r) {
  const double worst = r.result.solution.worst_distortion;
  if (!std::isfinite(worst)) return "some lengths shrink to nothing or are turned over";
  if (worst < 1.005) return "lengths are kept";
  return formatted("no length changes by more than a factor of %.3g", worst);
}

std::string end_text(const Result& r) {
  const newton::Summary& s = r.result.solution.summary;
  const std::string effort = counted(s.iterations, "iteration") + formatted(", %.2g s", s.seconds.total);
  if (s.converged()) return "converged (" + effort + ")";
  return "NOT converged: " + s.message + " (" + effort + ")";
}

std::string advice(const Result& r) {
  if (r.result.split.done) return "splitting has not done away with it: please report the model";
  if (r.options.has_pins() || !r.options.aligned.empty())
    return "charts with pinned or aligned vertices are not split";
  return "--overlap split divides and packs charts";
}

}  // namespace

std::string outcome(const Result& r) {
  return counted(r.result.start.charts.size(), "chart") + "; " + flips_text(r) + "; " + overlap_text(r) +
         "; " + stretch_text(r) + "; " + end_text(r);
}

std::vector<std::string> layout_warnings(const Result& r) {
  std::vector<std::string> warnings;
  const mesh::Overlap& overlap = r.result.layout.overlap;
  if (r.result.solution.has_vanished())
    warnings.push_back(
        "the layout has shrunk to a point: the energy falls as triangles shrink, without a least value");
  else if (!overlap.triangles.empty()) {
    const std::size_t charts = parameterization::charts_concerned(r.result.domain, overlap).size();
    warnings.push_back("the layout lies on itself: " + counted(overlap.triangles.size(), "triangle") +
                       " of " + counted(charts, "chart") + (r.result.layout.packed ? "" : " (not packed)") +
                       " overlap, the first is " + std::to_string(overlap.triangles.front()) + "; " +
                       advice(r));
  }
  return warnings;
}

}  // namespace isostretch::reports
