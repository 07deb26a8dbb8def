// Solvers in modules of their own.
#include "../src/solver_module.hpp"
#include "general_instances.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

namespace {

using namespace isostretch;

bool is_mapped(const std::string& library) {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
    if (line.find(library) != std::string::npos) return true;
  return false;
}

TEST_CASE("A module that is not there is named, and so is one without the function") {
  CHECK_THROWS_WITH_AS(baselines::load_solver("isostretch_nowhere", "isostretch_solve_by_nobody"),
                       doctest::Contains("isostretch_nowhere.so"), baselines::ModuleError);
}

TEST_CASE("A module is loaded when it is asked for, and one of another version is refused" *
          tests::needs_solvers({"nlopt_slsqp"})) {
  baselines::load_solver("isostretch_nlopt", "isostretch_solve_by_nlopt");
  CHECK(is_mapped("isostretch_nlopt"));
  CHECK_THROWS_WITH_AS(baselines::load_solver("isostretch_nlopt", "isostretch_solve_by_nobody"),
                       doctest::Contains("another version"), baselines::ModuleError);
}

}  // namespace
