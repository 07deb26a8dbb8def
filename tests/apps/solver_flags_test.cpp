// Linear solvers from outside on the command line.
#include "common/solver_flags.hpp"

#include <isostretch/sparse/solver.hpp>

#include <doctest/doctest.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <string>

using namespace isostretch;

TEST_CASE("--solver lists and takes a linear solver that the program has registered") {
  CLI::App before;
  app::SolverFlags of_before;
  of_before.declare(before);
  CHECK(before.help().find("solver_of_this_program") == std::string::npos);

  const sparse::Backend backend =
      sparse::register_solver("solver_of_this_program", [](const sparse::Options& options) {
        sparse::Options inner = options;
        inner.backend = sparse::Backend::eigen_ldlt;
        return sparse::make_solver(inner);
      });
  CLI::App cli;
  app::SolverFlags flags;
  flags.declare(cli);
  CHECK(cli.help().find("solver_of_this_program") != std::string::npos);
  cli.parse("--solver solver_of_this_program");
  newton::Options options;
  flags.apply(options);
  CHECK(options.solver.backend == backend);
  CHECK_THROWS_AS(cli.parse("--solver solver_of_nobody"), CLI::ValidationError);
}
