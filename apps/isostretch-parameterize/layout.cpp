#include "layout.hpp"

#include "common/terminal.hpp"

#include <isostretch/atlas/pack.hpp>
#include <isostretch/mesh/orientation.hpp>

#include <cmath>
#include <string>

namespace isostretch::app::parameterize {
namespace {

void pack_charts(const Start& start, const Options& options, Layout& layout) {
  std::vector<mesh::Points2> charts;
  std::vector<mesh::Triangles> triangles;
  for (const Chart& chart : start.charts) {
    charts.push_back(chart.gather(layout.uv));
    triangles.push_back(chart.mesh.triangles);
  }
  atlas::Packing packing;
  try {
    packing = atlas::pack(charts, triangles, {.margin = options.margin, .rotate = options.aligned.empty()});
  } catch (const Error& error) {
    warn(std::string("not packed: ") + error.what());  // the solution is worth more than its place
    return;
  }
  for (std::size_t c = 0; c < charts.size(); ++c) start.charts[c].scatter(charts[c], layout.uv);
  layout.packed = true;
  layout.scale *= packing.scale;
  layout.coverage = packing.coverage;
}

// Vertices of no triangle have a row of uv too; it must not lie outside the layout.
void place_unreferenced(const Start& start, Layout& layout) {
  std::vector<bool> referenced(static_cast<std::size_t>(layout.uv.rows()), false);
  for (const Chart& chart : start.charts)
    for (const int v : chart.open_vertex) referenced[static_cast<std::size_t>(v)] = true;
  for (Eigen::Index v = 0; v < layout.uv.rows(); ++v)
    if (!referenced[static_cast<std::size_t>(v)])
      layout.uv.row(v) = layout.uv.row(start.charts.front().open_vertex.front());
}

}  // namespace

Layout lay_out(const Domain& domain, const Start& start, const Solution& solution, const Options& options) {
  Layout layout;
  layout.uv = solution.uv * start.unit_length;
  layout.scale = start.unit_length / std::sqrt(start.total_area);
  for (const HardPin& pin : solution.pins.hard)
    if (pin.output) layout.uv.row(pin.node) = *pin.output;  // to the last bit as asked
  if (options.packs(start.charts.size())) pack_charts(start, options, layout);
  place_unreferenced(start, layout);
  layout.flipped = mesh::orientation(layout.uv, domain.open().triangles).flipped;
  return layout;
}

}  // namespace isostretch::app::parameterize
