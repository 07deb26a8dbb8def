// A square of two triangles is asked to turn inside out, and no solver of the problem lets it.
#include "turned_square.hpp"

#include <isostretch/baselines/solver.hpp>

int main() {
  using namespace isostretch;
  baselines::Instance instance{turned_square(), Vector(8)};
  instance.rest << 0, 0, 1, 0, 1, 1, 0, 1;
  double energies[2];
  for (int i = 0; i < 2; ++i) {
    const auto result = baselines::solve(i == 0 ? "interior_point" : "penalty_spline", instance);
    if (result.status != baselines::Status::converged || result.measures.inverted > 0) return 1;
    energies[i] = result.measures.energy;
  }
  return energies[0] < energies[1] * 1.00001 && energies[1] < energies[0] * 1.00001 ? 0 : 1;
}
