#pragma once

#include <isostretch/newton/options.hpp>

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace isostretch::app {

// --projection, --grad-tol, --max-iterations, --max-expansion, --time-limit, --solver, --ordering,
// --preconditioner, --largest-forcing: how the energy is minimised, the same in every app.
class SolverFlags {
 public:
  // `unit` completes the sentence on the gradient, for example ", with total area 1".
  void declare(CLI::App& cli, const std::string& unit = {});

  // Sets what was given on the command line, and leaves the rest. Throws Error naming the option's value when
  // it is none or is not compiled in.
  void apply(newton::Options& options) const;

 private:
  std::optional<std::string> projection_, solver_, ordering_, preconditioner_;
  std::optional<double> gradient_tolerance_, time_limit_, max_expansion_, largest_forcing_;
  std::optional<int> max_iterations_;
};

// Only the absolute test is left: what was asked for is what counts.
void set_gradient_tolerance(newton::Options& options, double tolerance);

}  // namespace isostretch::app
