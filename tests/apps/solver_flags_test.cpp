// Linear solvers from outside on the command line.
#include "common/option_flags.hpp"

#include <isostretch/newton/options.hpp>
#include <isostretch/scene/node.hpp>
#include <isostretch/scene/pipelines.hpp>
#include <isostretch/sparse/solver.hpp>

#include <doctest/doctest.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <string>

using namespace isostretch;

TEST_CASE("--backend lists and takes a linear solver that the program has registered") {
  newton::Options defaults;
  CLI::App before;
  app::OptionFlags of_before;
  of_before.declare(before, option_fields(defaults), "newton");
  CHECK(before.help().find("solver_of_this_program") == std::string::npos);

  const sparse::Backend backend =
      sparse::register_solver("solver_of_this_program", [](const sparse::Options& options) {
        sparse::Options inner = options;
        inner.backend = sparse::Backend::eigen_ldlt;
        return sparse::make_solver(inner);
      });
  CLI::App cli;
  app::OptionFlags flags;
  flags.declare(cli, option_fields(defaults), "newton");
  CHECK(cli.help().find("solver_of_this_program") != std::string::npos);
  cli.parse("--backend solver_of_this_program");
  scene::Value scene = scene::Value::object();
  flags.add_to(scene);
  newton::Options options;
  scene::read_newton(scene::Node(scene), options);
  CHECK(options.solver.backend == backend);
  CHECK_THROWS_AS(cli.parse("--backend solver_of_nobody"), CLI::ValidationError);
}
