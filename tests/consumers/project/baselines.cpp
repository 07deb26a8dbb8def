// A square of two triangles is asked to turn inside out, and no solver of the problem lets it; solvers in
// modules are found where the package is installed.
#include "turned_square.hpp"

#include <isostretch/baselines/solver.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

int main() {
  using namespace isostretch;
  std::vector<std::string> names{"interior_point", "penalty_spline"};
  for (const baselines::SolverInfo& info : baselines::solvers())
    if (info.name == "ipopt" && info.available()) names.emplace_back(info.name);
  baselines::Instance instance{turned_square(), Vector(8)};
  instance.rest << 0, 0, 1, 0, 1, 1, 0, 1;
  std::vector<double> energies;
  for (const std::string& name : names) {
    const auto result = baselines::solve(name, instance);
    if (result.status != baselines::Status::converged || result.measures.inverted > 0) {
      std::fprintf(stderr, "%s: %s\n", name.c_str(), result.message.c_str());
      return 1;
    }
    energies.push_back(result.measures.energy);
  }
  const auto [least, most] = std::minmax_element(energies.begin(), energies.end());
  return *most < *least * 1.00001 ? 0 : 1;
}
