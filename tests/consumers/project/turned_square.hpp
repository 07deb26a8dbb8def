#pragma once

#include <isostretch/sdp_penalty/problem.hpp>

// A square of two triangles that is asked to turn inside out.
inline isostretch::sdp_penalty::Problem turned_square() {
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
  return problem;
}
