#include "overlap.hpp"

#include <isostretch/mesh/seams.hpp>

#include <algorithm>

namespace isostretch::app::parameterize {
namespace {

// Of all charts together, which lie in one place as they were solved.
double share_of_charts(const Start& start, const mesh::Points2& uv) {
  double covered = 0, overlapped = 0;
  for (const Chart& chart : start.charts) {
    const mesh::Overlap own = mesh::find_overlap(chart.gather(uv), chart.mesh.triangles);
    covered += own.covered_area;
    overlapped += own.overlapped_area;
  }
  return covered > 0 ? overlapped / covered : 0;
}

// Of the side of a square as large as the surface. Well below a pixel of any texture.
constexpr double hairs[] = {1e-6, 4e-6, 1.6e-5};

// Sides of cuts that lie on each other by no more than a hair are moved apart, which splits nothing. What is
// held stays.
void part_sides_of_cuts(const Start& start, Solution& solution) {
  for (const Chart& chart : start.charts) {
    if (!chart.held_boundary.empty()) continue;
    mesh::Points2 uv = chart.gather(solution.uv);
    std::size_t least = mesh::find_overlap(uv, chart.mesh.triangles).triangles.size();
    for (const double hair : hairs) {
      if (least == 0) break;
      mesh::part_sides(uv, chart.mesh.triangles, hair);
      const std::size_t now = mesh::find_overlap(uv, chart.mesh.triangles).triangles.size();
      if (now >= least) continue;
      least = now;
      chart.scatter(uv, solution.uv);
    }
  }
}

mesh::Points2 carried(const mesh::Points2& uv, const std::vector<int>& previous) {
  mesh::Points2 now(static_cast<Eigen::Index>(previous.size()), 2);
  for (std::size_t v = 0; v < previous.size(); ++v)
    now.row(static_cast<Eigen::Index>(v)) = uv.row(previous[v]);
  return now;
}

// start.uv is of the cut that the solve began with, which may have been extended since; nobody asks for it
// any more.
void follow(const Domain& domain, const mesh::Division& division, Start& start, Solution& solution) {
  solution.uv = carried(solution.uv, division.previous_vertex);
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
  split.done = options.splits_overlap(start.charts.size());
  if (!split.done) return split;
  if (!options.has_pins() && options.aligned.empty()) part_sides_of_cuts(start, solution);
  split.share_before = share_of_charts(start, solution.uv);
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

}  // namespace isostretch::app::parameterize
