#include "layout.hpp"

#include "common/exit_code.hpp"

#include <isostretch/atlas/pack.hpp>
#include <isostretch/mesh/orientation.hpp>

#include <cmath>

namespace isostretch::app::parameterize {
namespace {

void pack_charts(const Start& start, const Options& options, Layout& layout) {
  std::vector<mesh::Points2> charts;
  std::vector<mesh::Triangles> triangles;
  for (const Chart& chart : start.charts) {
    charts.push_back(chart.gather(layout.uv));
    triangles.push_back(chart.mesh.triangles);
  }
  const atlas::Packing packing = failing_with(ExitCode::command_line, [&] {
    return atlas::pack(charts, triangles, {.margin = options.margin, .rotate = options.aligned.empty()});
  });
  for (std::size_t c = 0; c < charts.size(); ++c) start.charts[c].scatter(charts[c], layout.uv);
  layout.packed = true;
  layout.scale *= packing.scale;
  layout.coverage = packing.coverage;
}

}  // namespace

Layout lay_out(const Domain& domain, const Start& start, const Solution& solution, const Options& options) {
  Layout layout;
  layout.uv = solution.uv * start.unit_length;
  layout.scale = start.unit_length / std::sqrt(start.total_area);
  for (const HardPin& pin : solution.pins.hard)
    if (pin.output) layout.uv.row(pin.node) = *pin.output;  // to the last bit as asked
  if (options.packs(start.charts.size())) pack_charts(start, options, layout);
  layout.flipped = mesh::orientation(layout.uv, domain.open().triangles).flipped;
  return layout;
}

}  // namespace isostretch::app::parameterize
