#include "alignment.hpp"
#include "chart_runs.hpp"
#include "further_cut.hpp"
#include "placement.hpp"

#include <isostretch/core/log.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/newton/minimize.hpp>
#include <isostretch/parameterization/solution.hpp>
#include <isostretch/surface/orientation.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace isostretch::parameterization {
namespace {

// Of what the default cut goes on to, and how often: more is for --max-distortion.
constexpr double tip_distortion = 2.5;
constexpr int tip_rounds = 12;
constexpr double rough_decrement = 4e-3;  // a thousandth of the energy of an isometry

class Solver {
 public:
  Solver(Domain& domain, Start& start, const energies::AnyEnergy& energy, const Options& options,
         const Monitor& monitor)
      : domain_(domain), start_(start), energy_(energy), options_(options), monitor_(monitor) {
    options_.newton.stop = monitor.stop;
    solution_.uv = start.uv;
    solution_.stretches.assign(2 * static_cast<std::size_t>(domain.open().triangles.rows()), 1.0);
    pins_ = resolve_pins(domain, start, options_);
    lines_ = resolve_lines(domain, start, options_);
    soft_pin_energy_.assign(start.charts.size(), 0.0);
  }

  Solution run() {
    for (std::size_t c = 0; c < start_.charts.size(); ++c) solve_chart(static_cast<int>(c), Care::full, true);
    if (options_.max_distortion > 0) cut_further();
    if (reaches_tips()) reach_remaining_tips();
    sew_spurs();
    if (solution_.cuts > 0)
      log(LogLevel::info, "cut further from " + counted(solution_.cuts, "distorted place"));
    combine_runs(solution_.runs, solution_.summary, solution_.chart_of_row);
    solution_.worst_distortion = worst_distortion(solution_.stretches);
    solution_.pins = pins_;
    for (const double energy : soft_pin_energy_) solution_.soft_pin_energy += energy;
    return std::move(solution_);
  }

 private:
  newton::CallbackAction watch(const newton::Iteration& row, std::size_t chart) const {
    const std::string of = start_.charts.size() > 1 ? "chart " + std::to_string(chart) + " of " +
                                                          std::to_string(start_.charts.size()) + "  "
                                                    : "";
    monitor_.show(progress_of_cuts() + of + newton::progress_line(row));
    return newton::CallbackAction::proceed;
  }

  // The distortion so far and the bound that options.max_distortion sets.
  std::string progress_of_cuts() const {
    if (options_.max_distortion == 0 || solution_.cuts == 0) return "";
    return formatted("distortion %.3g, wanted %.3g, %d cuts  ", worst_, options_.max_distortion,
                     solution_.cuts);
  }

  // Between cuts it is enough to know where they are wanted.
  enum class Care { rough, full };

  newton::Options newton_options(Care care) const {
    newton::Options newton = options_.newton;
    if (care == Care::rough)
      newton.decrement_tolerance = std::max(newton.decrement_tolerance, rough_decrement);
    // What is left; a chart that has no time left still says so after its start.
    if (newton.time_limit > 0) newton.time_limit = std::max(newton.time_limit - timer_.seconds(), 1e-9);
    return newton;
  }

  void solve_chart(int number, Care care, bool first) {
    const Chart& chart = start_.charts[static_cast<std::size_t>(number)];
    const Pins pins = pins_.of_chart(chart);
    const assembly::Elements elements = assembly::elements_from(chart.rest);
    Vector x = positions(chart.gather(solution_.uv));
    const std::vector<Line> lines = lines_of_chart(lines_, chart);
    place_hard_pins(x, pins, elements, energy_, chart, options_);
    place_lines(x, lines, pins, elements, energy_, chart, options_);

    newton::Objective objective(2, elements.node_count);
    const auto& term = objective.add<newton::EnergyTerm>(elements, energy_);
    auto& soft_pins = objective.add<newton::SoftPinTerm>(2, elements.node_count, pins.soft);
    for (const HardPin& pin : pins.hard) objective.pin(pin.node);
    for (const int vertex : chart.held_boundary) objective.pin(vertex);
    tie_lines(objective, lines);

    Run run{number, first,
            newton::minimize(objective, x, newton_options(care),
                             [&](const newton::Iteration& row, const Vector&) {
                               return watch(row, static_cast<std::size_t>(number));
                             })};
    solution_.runs.push_back(std::move(run));
    if (care == Care::rough) rough_.insert(number);
    chart.scatter(points(x), solution_.uv);
    soft_pin_energy_[static_cast<std::size_t>(number)] = soft_pins.value(x).value;
    const std::vector<double> stretches = term.assembler().stretches(x.data());
    for (std::size_t t = 0; t < chart.triangle.size(); ++t)
      for (std::size_t i = 0; i < 2; ++i)
        solution_.stretches[2 * static_cast<std::size_t>(chart.triangle[t]) + i] = stretches[2 * t + i];
  }

  // All that further cuts change.
  struct State {
    Domain domain;
    Start start;
    Solution solution;
    std::vector<double> soft_pin_energy;
  };

  State state() const { return {domain_, start_, solution_, soft_pin_energy_}; }

  void go_back_to(State state) {
    domain_ = std::move(state.domain);
    start_ = std::move(state.start);
    solution_ = std::move(state.solution);
    soft_pin_energy_ = std::move(state.soft_pin_energy);
    rough_.clear();
  }

  double seam_length() const { return mesh::seam_length(domain_.input.vertices, domain_.cut.seams); }
  bool is_within_bound() const { return worst_distortion(solution_.stretches) <= options_.max_distortion; }

  // A part that is cut off may need cuts of its own, which only shows in the end.
  void cut_further() {
    State before = state();
    if (!cut_until_within_bound(true) || !may_go_on()) return;
    State with_parts = state();
    const double length = seam_length();
    const bool within = is_within_bound();
    go_back_to(std::move(before));
    cut_until_within_bound(false);
    const bool parts_pay = is_within_bound() == within ? length < seam_length() : within;
    log(LogLevel::debug,
        formatted("cut of %zu charts: %.4g, of %zu charts: %.4g", with_parts.start.charts.size(), length,
                  start_.charts.size(), seam_length()));
    if (parts_pay) go_back_to(std::move(with_parts));
  }

  // From vertices inside charts whose triangles are distorted most to the boundary, again and again; or
  // around them, if parts may be cut off. Returns whether any was.
  bool cut_until_within_bound(bool by_parts) {
    const double bound = options_.max_distortion;
    bool any_part = false;
    while (solution_.cuts < options_.max_cuts && may_go_on()) {
      if (by_parts && cut_part_off(bound)) {
        any_part = true;
        continue;
      }
      if (lengthen_cuts(bound, OnFromEnd::straight) || finish()) continue;
      const int triangle = worst_triangle(domain_, solution_.stretches, bound);
      if (triangle < 0) return any_part;
      ++solution_.cuts;
      divide_chart(triangle);
    }
    finish();
    return any_part;
  }

  bool may_go_on() const { return !monitor_.stop.stop_requested() && !out_of_time(); }

  // Solves what was solved roughly. Returns whether there was any.
  bool finish() {
    const std::set<int> rough = std::exchange(rough_, {});
    for (const int chart : rough) solve_chart(chart, Care::full, false);
    return !rough.empty();
  }

  // All that are far from each other at once. Returns whether there were any.
  bool lengthen_cuts(double bound, OnFromEnd on) {
    worst_ = worst_distortion(solution_.stretches);
    std::set<int> changed;
    for (const int vertex : worst_vertices(domain_, solution_.stretches, bound)) {
      if (solution_.cuts == options_.max_cuts) break;
      const int chart = cut_at(domain_, vertex, on, solution_.uv);
      if (chart < 0) continue;
      ++solution_.cuts;
      changed.insert(chart);
    }
    for (const int chart : changed) {
      start_.charts[static_cast<std::size_t>(chart)] = make_chart(domain_, start_, chart);
      solve_chart(chart, Care::rough, false);
    }
    return !changed.empty();
  }

  // A cut that curvature alone has placed ends a little beside where it should, or leaves out a fine detail.
  void reach_remaining_tips() {
    for (int round = 0; round < tip_rounds && may_go_on(); ++round)
      if (!lengthen_cuts(tip_distortion, OnFromEnd::to_vertex) && !finish()) return;
    finish();
  }

  // What further cuts leave of one to three edges is closed where that asks for no distortion beyond what
  // there is.
  void sew_spurs() {
    if (solution_.cuts == 0 || domain_.seams_from_input) return;
    const double bound = std::max(options_.max_distortion, worst_distortion(solution_.stretches));
    for (const std::vector<int>& path : mesh::spurs(domain_.cut)) {
      if (!may_go_on()) return;
      State before = state();
      if (!solve_sewn(path) || worst_distortion(solution_.stretches) > bound) go_back_to(std::move(before));
    }
  }

  // Returns whether that went well. Where both sides are far apart their middle is no start.
  bool solve_sewn(const std::vector<int>& path) {
    const std::vector<Chart> before = start_.charts;
    const int number = sew(domain_, path, solution_.uv);
    start_.charts = make_charts(domain_, start_);
    if (start_.charts.size() != before.size()) return false;
    for (std::size_t c = 0; c < before.size(); ++c) start_.charts[c].method = before[c].method;
    const Chart& chart = start_.charts[static_cast<std::size_t>(number)];
    if (mesh::count_flipped(chart.gather(solution_.uv), chart.mesh.triangles) > 0) return false;
    solve_chart(number, Care::full, false);
    return solution_.runs.back().summary.converged();
  }

  bool reaches_tips() const {
    return options_.max_distortion == 0 && options_.reaches_tips() && domain_.closed;
  }

  // A triangle with all corners on the boundary can only be cut off.
  void divide_chart(int triangle) {
    for (const int chart : follow(cut_off(domain_, triangle, solution_.uv)))
      solve_chart(chart, Care::full, false);
  }

  // Charts are numbered anew, as what they were part of says. Returns those that are not as they were; the
  // others keep their solution.
  std::vector<int> follow(const std::vector<int>& part_of) {
    std::vector<Chart> charts = make_charts(domain_, start_);
    std::vector<int> number(start_.charts.size(), -1), changed;
    std::set<int> rough;
    for (std::size_t c = 0; c < part_of.size(); ++c) {
      const auto whole = static_cast<std::size_t>(part_of[c]);
      charts[c].method = start_.charts[whole].method;
      if (number[whole] < 0) number[whole] = static_cast<int>(c);
      if (rough_.count(part_of[c]) > 0) rough.insert(static_cast<int>(c));
      if (charts[c].open_vertex.size() != start_.charts[whole].open_vertex.size())
        changed.push_back(static_cast<int>(c));
    }
    start_.charts = std::move(charts);
    rough_ = std::move(rough);
    soft_pin_energy_.assign(start_.charts.size(), 0.0);  // pins and further cuts exclude each other
    for (Run& run : solution_.runs) run.chart = number[static_cast<std::size_t>(run.chart)];
    return changed;
  }

  // A distorted place far from the boundary is cut off where the way around it is shorter than the one to it.
  // Returns whether there was any.
  bool cut_part_off(double bound) {
    const std::vector<int> part = part_to_cut_off(domain_, solution_.stretches, bound);
    if (part.empty()) return false;
    ++solution_.cuts;
    for (const int chart : follow(make_apart(domain_, part, solution_.uv)))
      solve_chart(chart, Care::rough, false);
    return true;
  }

  bool out_of_time() const {
    return options_.newton.time_limit > 0 && timer_.seconds() >= options_.newton.time_limit;
  }

  Domain& domain_;
  Start& start_;
  const energies::AnyEnergy& energy_;
  Options options_;
  const Monitor& monitor_;
  Timer timer_;
  Pins pins_;
  std::vector<Line> lines_;
  double worst_ = 1;                     // distortion, when cuts were last chosen
  std::set<int> rough_;                  // charts that were not solved fully
  std::vector<double> soft_pin_energy_;  // of every chart
  Solution solution_;
};

}  // namespace

bool Solution::has_vanished() const {
  constexpr double next_to_none = 1e-9;
  return std::all_of(stretches.begin(), stretches.end(), [](double s) { return std::abs(s) < next_to_none; });
}

Solution solve(Domain& domain, Start& start, const energies::AnyEnergy& energy, const Options& options,
               const Monitor& monitor) {
  return Solver(domain, start, energy, options, monitor).run();
}

}  // namespace isostretch::parameterization
