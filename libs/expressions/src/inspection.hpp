#pragma once

#include "graph.hpp"

#include <array>
#include <vector>

namespace isostretch::expressions {

// Values of an expression at single points, one operation after the other: to find out about it.
class Evaluator {
 public:
  Evaluator(const Graph& graph, Node root, int dim) : graph_(graph), root_(root), dim_(dim) {}
  double operator()(const std::array<double, 3>& stretches);

 private:
  const Graph& graph_;
  Node root_;
  int dim_;
  std::vector<double> values_;
};

// Of positive stretches between 1/3 and 3.
bool finite_somewhere(const Graph& graph, Node root, int dim);

// Whether exchanging stretches changes nothing, beyond rounding, wherever it was tried.
bool is_symmetric(const Graph& graph, Node root, int dim);

// Whether the domain ends at det F = 0: psi is not finite somewhere with det F <= 0, or diverges, however
// slowly, as the smallest stretch vanishes.
bool ends_at_zero_determinant(const Graph& graph, Node root, int dim);

}  // namespace isostretch::expressions
