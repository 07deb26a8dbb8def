#include <isostretch/parameterization/overlap_split.hpp>
#include <isostretch/surface/seams.hpp>

#include <algorithm>
#include <utility>

namespace isostretch::parameterization {
namespace {

// Of the side of a square as large as the surface. Well below a pixel of any texture.
constexpr double hairs[] = {1e-6, 4e-6, 1.6e-5};

// Sides of cuts that lie on each other by no more than a hair are moved apart, which splits nothing. Returns
// what overlap is left in the chart.
mesh::Overlap part_sides_of_cuts(const Chart& chart, mesh::Points2& layout) {
  mesh::Points2 uv = chart.gather(layout);
  mesh::Overlap least = mesh::find_overlap(uv, chart.mesh.triangles);
  if (!chart.held_boundary.empty()) return least;
  for (const double hair : hairs) {
    if (least.triangles.empty()) break;
    mesh::part_sides(uv, chart.mesh.triangles, hair);
    mesh::Overlap now = mesh::find_overlap(uv, chart.mesh.triangles);
    if (now.triangles.size() >= least.triangles.size()) continue;
    least = std::move(now);
    chart.scatter(uv, layout);
  }
  return least;
}

// Of all charts together, which lie in one place as they were solved.
struct ChartsOverlap {
  double covered = 0, overlapped = 0;
  bool any = false;
  double share() const { return covered > 0 ? overlapped / covered : 0; }
};

ChartsOverlap overlap_of_charts(const Start& start, mesh::Points2& layout, bool sides_may_move) {
  ChartsOverlap all;
  for (const Chart& chart : start.charts) {
    const mesh::Overlap own = sides_may_move ? part_sides_of_cuts(chart, layout)
                                             : mesh::find_overlap(chart.gather(layout), chart.mesh.triangles);
    all.covered += own.covered_area;
    all.overlapped += own.overlapped_area;
    all.any = all.any || !own.triangles.empty();
  }
  return all;
}

// start.uv is of the cut that the solve began with, which may have been extended since; nobody asks for it
// any more.
void follow(const Domain& domain, const mesh::Division& division, Start& start, Solution& solution) {
  solution.uv = rows_of(solution.uv, division.previous_vertex);
  std::vector<Chart> charts = make_charts(domain, start);
  for (std::size_t c = 0; c < charts.size(); ++c) {
    charts[c].solved_as = division.previous_chart[c];
    charts[c].method = start.charts[static_cast<std::size_t>(charts[c].solved_as)].method;
  }
  start.charts = std::move(charts);
}

}  // namespace

OverlapSplit split_overlap(Domain& domain, Start& start, Solution& solution, const Options& options) {
  OverlapSplit split;
  split.done = options.splits_overlap(start.charts.size()) && !solution.has_vanished();
  if (!split.done) return split;
  const ChartsOverlap overlap =
      overlap_of_charts(start, solution.uv, !options.has_pins() && options.aligned.empty());
  split.share_before = overlap.share();
  if (!overlap.any) return split;
  const std::size_t charts = start.charts.size();
  const double length = mesh::seam_length(domain.input.vertices, domain.cut.seams);
  follow(domain, mesh::split_overlap(domain.cut, solution.uv), start, solution);
  split.charts_added = start.charts.size() - charts;
  split.cut_length = mesh::seam_length(domain.input.vertices, domain.cut.seams) - length;
  return split;
}

std::vector<int> charts_concerned(const Domain& domain, const mesh::Overlap& overlap) {
  std::vector<int> charts;
  for (const int t : overlap.triangles) charts.push_back(domain.cut.chart[static_cast<std::size_t>(t)]);
  std::sort(charts.begin(), charts.end());
  charts.erase(std::unique(charts.begin(), charts.end()), charts.end());
  return charts;
}

}  // namespace isostretch::parameterization
