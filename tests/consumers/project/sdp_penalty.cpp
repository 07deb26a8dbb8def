// A square of two triangles is asked to turn inside out, and does not.
#include <isostretch/sdp_penalty/solver.hpp>

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
  Vector x;
  const auto summary = sdp_penalty::solve(problem, x);
  const bool inverted_before = summary.trace.front().inverted == 2;
  return summary.status == sdp_penalty::Status::optimal && inverted_before && summary.inverted == 0 ? 0 : 1;
}
