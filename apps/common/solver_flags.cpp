#include "common/solver_flags.hpp"

#include "common/validators.hpp"

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/sparse/solver.hpp>

#include <CLI/CLI.hpp>

#include <vector>

namespace isostretch::app {
namespace {

std::vector<std::string> solver_names() {
  std::vector<std::string> names{"automatic"};
  for (const sparse::Backend backend : sparse::available_backends())
    names.emplace_back(sparse::backend_name(backend));
  return names;
}

std::vector<std::string> ordering_names() {
  std::vector<std::string> names{"automatic"};
  for (const sparse::Ordering ordering : sparse::available_orderings())
    names.emplace_back(sparse::ordering_name(ordering));
  return names;
}

std::vector<std::string> preconditioner_names() {
  std::vector<std::string> names;
  for (const sparse::Preconditioner preconditioner : sparse::all_preconditioners())
    names.emplace_back(sparse::preconditioner_name(preconditioner));
  return names;
}

}  // namespace

void SolverFlags::declare(CLI::App& cli, const std::string& unit) {
  cli.option_defaults()->group("Solver");
  const newton::Options defaults;
  cli.add_option("--projection", projection_,
                 "How the Hessian is made positive definite: " + listed(newton::projection_names()))
      ->check(one_of(newton::projection_names()))
      ->type_name("NAME")
      ->default_str(std::string(newton::projection_name(defaults.projection)));
  cli.add_option("--grad-tol", gradient_tolerance_,
                 "Stop at |gradient|_inf <= this" + unit + "; default: a test that adapts to the scale")
      ->check(positive())
      ->type_name("X");
  cli.add_option("--max-iterations", max_iterations_, "Stop a solve after so many Newton iterations")
      ->check(whole_number_between(0, 1'000'000'000))
      ->type_name("N")
      ->default_str(std::to_string(defaults.max_iterations));
  cli.add_option("--max-expansion", max_expansion_,
                 "Let steps that gain more than promised grow up to this factor; 1: never")
      ->check(number_between(1.0, 1e6))
      ->type_name("X")
      ->default_str(to_text(defaults.max_expansion));
  cli.add_option("--time-limit", time_limit_, "Stop after so many seconds; 0: no limit")
      ->check(not_negative())
      ->type_name("SECONDS");
  cli.add_option("--solver", solver_, "Solver of the linear systems: " + listed(solver_names()))
      ->type_name("NAME")
      ->default_str("automatic");
  cli.add_option("--ordering", ordering_,
                 "Order in which direct solvers eliminate unknowns: " + listed(ordering_names()))
      ->type_name("NAME")
      ->default_str("automatic");
  cli.add_option("--preconditioner", preconditioner_,
                 "Preconditioner of --solver pcg: " + listed(preconditioner_names()))
      ->check(one_of(preconditioner_names()))
      ->type_name("NAME")
      ->default_str(std::string(sparse::preconditioner_name(defaults.solver.pcg_preconditioner)));
  cli.add_option(
         "--largest-forcing", largest_forcing_,
         "How inexact (relative residual) the first steps of iterative solvers may be; 0: always exact")
      ->check(number_between(0.0, 0.99))
      ->type_name("X")
      ->default_str(to_text(defaults.largest_forcing));
}

void SolverFlags::apply(newton::Options& options) const {
  if (projection_) options.projection = newton::projection_from_name(*projection_);
  if (gradient_tolerance_) set_gradient_tolerance(options, *gradient_tolerance_);
  if (max_iterations_) options.max_iterations = *max_iterations_;
  if (max_expansion_) options.max_expansion = *max_expansion_;
  if (time_limit_) options.time_limit = *time_limit_;
  if (solver_) options.solver.backend = sparse::backend_from_name(*solver_);
  if (ordering_) options.solver.ordering = sparse::ordering_from_name(*ordering_);
  if (preconditioner_) options.solver.pcg_preconditioner = sparse::preconditioner_from_name(*preconditioner_);
  if (largest_forcing_) options.largest_forcing = *largest_forcing_;
  sparse::make_solver(options.solver);  // says at once when it is not compiled in
}

void set_gradient_tolerance(newton::Options& options, double tolerance) {
  options.gradient_tolerance = tolerance;
  options.scaled_gradient_tolerance = 0;
}

}  // namespace isostretch::app
