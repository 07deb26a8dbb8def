#include "start.hpp"

#include "common/exit_code.hpp"
#include "common/terminal.hpp"

#include <isostretch/mesh/orientation.hpp>
#include <isostretch/mesh/tutte.hpp>

#include <cmath>
#include <string>

namespace isostretch::app::parameterize {
namespace {

mesh::Points2 tutte(const Domain& domain, const Options& options) {
  const mesh::TutteResult result = mesh::tutte_embedding(domain.open, {.solver = options.newton.solver});
  if (result.status == mesh::TutteStatus::failed)
    throw Failure(ExitCode::solver_failed, "no start: " + result.message + "; nothing is written");
  return result.uv;
}

std::string list_some(const std::vector<int>& numbers) {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(numbers.size(), most); ++i)
    text += (i ? ", " : "") + std::to_string(numbers[i]);
  if (numbers.size() > most) text += ", ... (" + std::to_string(numbers.size()) + " in all)";
  return text;
}

void require_startable(const std::vector<int>& flipped, const energies::AnyEnergy& energy, Initial initial) {
  if (flipped.empty()) return;
  const std::string what = std::string(initial == Initial::tutte ? "Tutte's embedding" : "the input's uv") +
                           " turns over or collapses triangle(s) " + list_some(flipped);
  if (energy.has_barrier())
    throw Error(what + ", where the energy '" + energy.name() +
                "' is infinite; start elsewhere or choose an energy that is finite under inversion");
  warn(what);
}

Start rest_shape(const Domain& domain, const Options& options) {
  Start start;
  start.elements = mesh::flat_elements(domain.open);
  start.total_area = mesh::total_weight(start.elements);
  const double shrink = mesh::scale_to_total_weight(start.elements, 1.0);
  start.unit_length = options.keep_normalized ? 1.0 : 1.0 / shrink;
  return start;
}

}  // namespace

Start make_start(const Domain& domain, const energies::AnyEnergy& energy, const Options& options) {
  const auto make = [&] {
    Start start = rest_shape(domain, options);
    start.uv = options.initial == Initial::tutte ? tutte(domain, options)
                                                 : mesh::Points2(domain.input_uv / start.unit_length);
    const auto flipped = mesh::orientation(start.uv, domain.open.triangles).flipped;
    start.flipped = static_cast<int>(flipped.size());
    require_startable(flipped, energy, options.initial);
    return start;
  };
  return failing_with(ExitCode::input, [&] { return naming_file(options.model, make); });
}

}  // namespace isostretch::app::parameterize
