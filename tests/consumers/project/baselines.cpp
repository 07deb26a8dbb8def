// A square of two triangles is asked to turn inside out, and no solver of the problem lets it.
#include <isostretch/baselines/solver.hpp>

int main() {
  using namespace isostretch;
  sdp_penalty::Problem problem;
  problem.elements.dim = 2;
  problem.elements.nodes_per_element = 3;
  problem.elements.points_per_element = 1;
  problem.elements.node_count = 4;
  problem.elements.nodes = {0, 1, 2, 0, 2, 3};
  problem.elements.gradients = {-1, 0, 1, -1, 0, 1, 0, -1, 1, 0, -1, 1};
  problem.elements.weights = {0.5, 0.5};
  problem.rotations = {1, 0, 0, 1, 1, 0, 0, 1};
  problem.weights = sdp_penalty::volume_weights(problem.elements);
  problem.targets = {{0, {0, 0}}, {1, {-1, 0}}, {2, {-1, 1}}, {3, {0, 1}}};
  baselines::Instance instance{problem, Vector(8)};
  instance.rest << 0, 0, 1, 0, 1, 1, 0, 1;
  double energies[2];
  for (int i = 0; i < 2; ++i) {
    const auto result = baselines::solve(i == 0 ? "interior_point" : "penalty_spline", instance);
    if (result.status != baselines::Status::converged || result.measures.inverted > 0) return 1;
    energies[i] = result.measures.energy;
  }
  return energies[0] < energies[1] * 1.00001 && energies[1] < energies[0] * 1.00001 ? 0 : 1;
}
