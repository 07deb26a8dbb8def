#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/newton/objective.hpp>
#include <isostretch/newton/term.hpp>
#include <isostretch/parameterization/charts.hpp>
#include <isostretch/surface/boundary.hpp>
#include <isostretch/surface/components.hpp>
#include <isostretch/surface/orientation.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace isostretch::parameterization {
namespace {

std::string list_some(const std::vector<int>& numbers) {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(numbers.size(), most); ++i)
    text += (i ? ", " : "") + std::to_string(numbers[i]);
  if (numbers.size() > most) text += ", ... (" + std::to_string(numbers.size()) + " in all)";
  return text;
}

Start rest_shape(const Domain& domain, const Options& options) {
  Start start;
  start.rest = mesh::flat_elements(domain.open());
  start.total_area = mesh::total_weight(start.rest);
  const double shrink = mesh::scale_to_total_weight(start.rest, 1.0);
  start.unit_length = options.units() == UvUnits::area ? 1.0 : 1.0 / shrink;
  start.uv.setZero(domain.open().vertices.rows(), 2);
  return start;
}

// The elements of some triangles, with nodes renumbered as the chart has them.
mesh::ElementArrays elements_of(const Chart& chart, const mesh::ElementArrays& whole) {
  mesh::ElementArrays rest;
  rest.dim = whole.dim;
  rest.nodes_per_element = whole.nodes_per_element;
  rest.points_per_element = whole.points_per_element;
  rest.node_count = static_cast<int>(chart.mesh.vertices.rows());
  const std::size_t per_element = whole.gradients.size() / whole.weights.size();
  for (std::size_t t = 0; t < chart.triangle.size(); ++t) {
    const auto from = static_cast<std::size_t>(chart.triangle[t]);
    for (int c = 0; c < 3; ++c) rest.nodes.push_back(chart.mesh.triangles(static_cast<Eigen::Index>(t), c));
    const auto gradients = whole.gradients.begin() + static_cast<std::ptrdiff_t>(from * per_element);
    rest.gradients.insert(rest.gradients.end(), gradients,
                          gradients + static_cast<std::ptrdiff_t>(per_element));
    rest.weights.push_back(whole.weights[from]);
  }
  return rest;
}

Chart from_part(mesh::Part part, const mesh::ElementArrays& whole) {
  Chart chart;
  chart.mesh = std::move(part.mesh);
  chart.open_vertex = std::move(part.original_vertex);
  chart.triangle = std::move(part.original_triangle);
  chart.rest = elements_of(chart, whole);
  return chart;
}

// The boundary of every chart, or only what lies on the circle or square.
std::vector<int> held_boundary(const Chart& chart, Boundary boundary) {
  if (boundary == Boundary::free) return {};
  const auto loops = mesh::boundary_loops(chart.mesh);
  if (boundary != Boundary::fixed) return loops[mesh::longest_loop(chart.mesh, loops)];
  std::vector<int> all;
  for (const auto& loop : loops) all.insert(all.end(), loop.begin(), loop.end());
  return all;
}

std::vector<int> corners_of(const Domain& domain, const Chart& chart, const Options& options) {
  std::vector<int> corners;
  const std::vector<int>& held = chart.held_boundary;
  for (const int corner : options.corners) {
    const int open = open_vertex(domain, corner, "corners");
    const auto found = std::find(chart.open_vertex.begin(), chart.open_vertex.end(), open);
    if (found == chart.open_vertex.end())
      throw OptionError("corners", "vertex " + std::to_string(corner) + " is in another chart than the rest");
    corners.push_back(static_cast<int>(found - chart.open_vertex.begin()));
    if (std::find(held.begin(), held.end(), corners.back()) == held.end())
      throw OptionError("corners", "vertex " + std::to_string(corner) + " is not on the boundary");
  }
  return corners;
}

// Said before the solve, not after it: equal squares need this much at least.
void require_room(const Options& options, std::size_t charts) {
  if (options.packs(charts) && options.margin * std::sqrt(static_cast<double>(charts)) >= 0.9)
    throw OptionError("margin", to_text(options.margin) + " of the square leaves no room for " +
                                    std::to_string(charts) + " charts");
}

// The straight side of a square is where a triangle can end up flat through no fault of the mesh.
std::string held_flat(const Chart& chart, const std::vector<int>& flipped) {
  for (const int t : flipped) {
    bool held = true;
    for (int c = 0; c < 3; ++c)
      held = held && std::find(chart.held_boundary.begin(), chart.held_boundary.end(),
                               chart.mesh.triangles(t, c)) != chart.held_boundary.end();
    if (held)
      return "; triangle " + std::to_string(chart.triangle[static_cast<std::size_t>(t)]) +
             " has all its corners on the boundary that is held: choose other corners or another boundary";
  }
  return "";
}

void embed(const Domain& domain, const Options& options, const std::string& name, Chart& chart,
           Start& start) {
  StartOptions how;
  how.tutte.solver = options.newton.solver;
  how.tutte.boundary = options.boundary == Boundary::square ? BoundaryShape::square : BoundaryShape::circle;
  how.tutte.corners = corners_of(domain, chart, options);
  how.keep_boundary = options.boundary != Boundary::free;
  how.stop = options.newton.stop;
  const StartResult result = flip_free_start(chart.mesh, chart.rest, how);
  if (result.uv.rows() == 0) throw Error(ErrorKind::unsolved, name + "no start: " + result.message);
  if (result.method == StartMethod::untangled)
    log(LogLevel::info, name + "Tutte's embedding collapsed triangles: untangled in " +
                            std::to_string(result.untangling.iterations) + " iterations");
  if (!result.flipped.empty() && options.newton.stop.should_stop())
    throw Error(ErrorKind::stopped, "interrupted before there was a start");
  chart.method = result.method;
  chart.scatter(result.uv, start.uv);
}

double value(const energies::AnyEnergy& energy, const assembly::Elements& elements, const mesh::Points2& uv) {
  newton::Objective objective(2, elements.node_count);
  objective.add<newton::EnergyTerm>(elements, energy);
  Vector x(uv.size());
  std::copy(uv.data(), uv.data() + uv.size(), x.data());
  return objective.value(x).value;
}

// By which a layout whose units say nothing about the model's is brought to its size: that of least energy,
// within a factor of four of the one that gives it the area of the model. Golden section in the logarithm.
double best_scale(const Domain& domain, const Start& start, const energies::AnyEnergy& energy) {
  const double area = mesh::orientation(start.uv, domain.open().triangles).total_area;
  if (!(area > 0)) return 1;
  const double same_area = 1 / std::sqrt(area), golden = 0.5 * (std::sqrt(5.0) - 1);
  const assembly::Elements elements = assembly::elements_from(start.rest);
  const auto at = [&](double log_scale) {
    return value(energy, elements, start.uv * (same_area * std::exp(log_scale)));
  };
  double low = -std::log(4.0), high = std::log(4.0);
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double at_left = at(left), at_right = at(right);
  while (high - low > 1e-9) {
    if (at_left < at_right) {
      high = std::exchange(right, left);
      at_right = at_left;
      at_left = at(left = high - golden * (high - low));
    } else {
      low = std::exchange(left, right);
      at_left = at_right;
      at_right = at(right = low + golden * (high - low));
    }
  }
  const double best = 0.5 * (low + high);
  return at(best) < at(0) ? same_area * std::exp(best) : same_area;
}

void require_startable(const Chart& chart, const Start& start, const std::string& name,
                       const energies::AnyEnergy& energy, const Options& options) {
  const auto flipped = mesh::orientation(chart.gather(start.uv), chart.mesh.triangles).flipped;
  if (flipped.empty()) return;
  std::vector<int> in_input;
  for (const int t : flipped) in_input.push_back(chart.triangle[static_cast<std::size_t>(t)]);
  const std::string what = name + (options.initial == Initial::tutte ? "the start" : "the input's uv") +
                           " turns over or collapses triangle(s) " + list_some(in_input);
  if (energy.has_barrier())
    throw Error(what + ", where the energy '" + energy.name() + "' is infinite" + held_flat(chart, flipped));
  log(LogLevel::warning, what);
}

}  // namespace

mesh::Points2 Chart::gather(const mesh::Points2& uv) const {
  return rows_of(uv, open_vertex);
}

void Chart::scatter(const mesh::Points2& own, mesh::Points2& uv) const {
  for (std::size_t v = 0; v < open_vertex.size(); ++v)
    uv.row(open_vertex[v]) = own.row(static_cast<Eigen::Index>(v));
}

std::vector<Chart> make_charts(const Domain& domain, const Start& start) {
  std::vector<Chart> charts;
  for (mesh::Part& part : mesh::split(domain.open(), domain.cut.chart))
    charts.push_back(from_part(std::move(part), start.rest));
  return charts;
}

Chart make_chart(const Domain& domain, const Start& start, int number) {
  std::vector<int> label = domain.cut.chart;
  for (int& chart : label) chart = chart == number ? 0 : 1;
  return from_part(std::move(mesh::split(domain.open(), label).front()), start.rest);
}

Start make_start(const Domain& domain, const energies::AnyEnergy& energy, const Options& given,
                 const Monitor& monitor) {
  Options options = given;
  options.newton.stop = monitor.stop;
  Start start = rest_shape(domain, options);
  if (options.initial == Initial::input) {
    start.uv = domain.input_uv / start.unit_length;
    if (options.units() == UvUnits::square) start.uv *= best_scale(domain, start, energy);
  }
  start.charts = make_charts(domain, start);
  if (!options.corners.empty() && start.charts.size() > 1)
    throw OptionError("corners", "the surface falls into " + std::to_string(start.charts.size()) +
                                     " charts; only one can have corners");
  require_room(options, start.charts.size());
  for (std::size_t c = 0; c < start.charts.size(); ++c) {
    Chart& chart = start.charts[c];
    chart.held_boundary = held_boundary(chart, options.boundary);
    const std::string name = start.charts.size() == 1 ? "" : "chart " + std::to_string(c) + ": ";
    if (options.initial == Initial::tutte) embed(domain, options, name, chart, start);
    require_startable(chart, start, name, energy, options);
  }
  start.flipped = mesh::count_flipped(start.uv, domain.open().triangles);
  return start;
}

}  // namespace isostretch::parameterization
