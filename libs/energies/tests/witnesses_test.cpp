// Closed forms, automatic derivatives and finite differences of every built-in energy. A file of its own: its
// templates take a minute to compile.
#include "builtins.hpp"

#include <isostretch/testing/check_energy.hpp>

#include <doctest/doctest.h>

using namespace isostretch;
using namespace isostretch::energies::tests;

TEST_CASE("three witnesses of every energy") {
  for_each_varied_builtin([](auto energy) {
    const auto report = testing::check_energy(energy);
    CHECK_MESSAGE(report.ok(), report.text());
  });
}
