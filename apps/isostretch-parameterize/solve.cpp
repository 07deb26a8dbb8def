#include "solve.hpp"

#include "common/interrupt.hpp"
#include "common/newton_report.hpp"
#include "common/terminal.hpp"
#include "pins.hpp"

#include <isostretch/mesh/orientation.hpp>
#include <isostretch/newton/minimize.hpp>

#include <utility>

namespace isostretch::app::parameterize {
namespace {

newton::CallbackAction watch(const newton::Iteration& row, const Vector&) {
  show_progress(progress_line(row));
  return interrupted() ? newton::CallbackAction::stop : newton::CallbackAction::proceed;
}

void explain_interrupt(newton::Summary& summary) {
  if (summary.status == newton::Status::stopped_by_callback) summary.message = "interrupted (Ctrl-C)";
}

}  // namespace

Solution solve(const Domain& domain, const Start& start, const energies::AnyEnergy& energy,
               const Options& options) {
  const Pins pins = resolve_pins(domain, start, options);
  const assembly::Elements elements = assembly::elements_from(start.elements);
  Vector x = positions(start.uv);
  place_hard_pins(x, pins, elements, energy, domain, options);

  newton::Objective objective(2, elements.node_count);
  const auto& term = objective.add<newton::EnergyTerm>(elements, energy);
  auto& soft_pins = objective.add<newton::SoftPinTerm>(2, elements.node_count, pins.soft);
  for (const HardPin& pin : pins.hard) objective.pin(pin.node);

  Solution solution;
  solution.summary = newton::minimize(objective, x, options.newton, watch);
  clear_progress();
  explain_interrupt(solution.summary);
  solution.stretches = term.assembler().stretches(x.data());
  solution.soft_pin_energy = soft_pins.value(x).value;
  solution.uv = points(x) * start.unit_length;
  for (const HardPin& pin : pins.hard)
    if (pin.output) solution.uv.row(pin.node) = *pin.output;  // to the last bit as asked
  solution.flipped = mesh::orientation(solution.uv, domain.open.triangles).flipped;
  solution.pinned = pins.nodes();
  return solution;
}

}  // namespace isostretch::app::parameterize
