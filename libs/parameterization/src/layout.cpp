#include <isostretch/core/log.hpp>
#include <isostretch/parameterization/layout.hpp>
#include <isostretch/parameterization/pack.hpp>
#include <isostretch/surface/orientation.hpp>

#include <cmath>
#include <string>

namespace isostretch::parameterization {
namespace {

void pack_charts(const Start& start, const Options& options, Layout& layout) {
  std::vector<mesh::Points2> charts;
  std::vector<mesh::Triangles> triangles;
  for (const Chart& chart : start.charts) {
    charts.push_back(chart.gather(layout.uv));
    triangles.push_back(chart.mesh.triangles);
  }
  Packing packing;
  try {
    packing = pack(charts, triangles, {.margin = options.margin, .rotate = options.aligned.empty()});
  } catch (const Error& error) {
    log(LogLevel::warning,
        std::string("not packed: ") + error.what());  // the solution is worth more than its place
    return;
  }
  for (std::size_t c = 0; c < charts.size(); ++c) start.charts[c].scatter(charts[c], layout.uv);
  layout.packed = true;
  layout.coverage = packing.coverage;
  if (options.units() == UvUnits::square)
    layout.scale *= packing.scale;
  else
    layout.uv /= packing.scale;
}

// Into the unit square without turning it, where charts stay beside or on each other as they are.
void fit_into_square(const Options& options, Layout& layout) {
  const Eigen::RowVector2d low = layout.uv.colwise().minCoeff(), size = layout.uv.colwise().maxCoeff() - low;
  const double scale = (1 - 2 * options.margin) / size.maxCoeff();
  if (!std::isnormal(scale)) return;  // shrunk to a point
  layout.uv = (layout.uv.rowwise() - (low + 0.5 * size)) * scale;
  layout.uv.array() += 0.5;
  layout.scale *= scale;
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
  place_unreferenced(start, layout);
  if (options.packs(start.charts.size())) pack_charts(start, options, layout);
  if (!layout.packed && options.units() == UvUnits::square) fit_into_square(options, layout);
  place_unreferenced(start, layout);
  layout.flipped = mesh::orientation(layout.uv, domain.open().triangles).flipped;
  if (layout.uv.allFinite()) layout.overlap = mesh::find_overlap(layout.uv, domain.open().triangles);
  return layout;
}

}  // namespace isostretch::parameterization
