#pragma once

#include "graph.hpp"

#include <optional>
#include <unordered_map>

namespace isostretch::expressions {

/// An expression as its value at rest and a node for how far it is from there. Differences are made by rules
/// in which nothing of the size of the value at rest cancels: (a b) - a0 b0 = a0 (b - b0) + b0 (a - a0) + (a
/// - a0) (b - b0), exp(a) - exp(a0) = exp(a0) expm1(a - a0), and so on from the differences of invariants and
/// stretches, which kernels have to a rounding of themselves. Terms of an energy that cancel at rest keep
/// their digits near it in this form.
class RestDifferences {
 public:
  RestDifferences(Graph& graph, int dim) : graph_(graph), dim_(dim) {}

  /// Returns the expression as the sum of both; nothing where it is not finite at rest.
  std::optional<Node> operator()(Node expression);

 private:
  struct Split {
    double rest;
    Node difference;
  };
  Split split(Node node);
  Split made(Node node);
  Split of_sum(const Operation& o, double sign);
  Split of_product(const Operation& o);
  Split of_quotient(Node node, const Operation& o);
  Split of_function(Node node, const Operation& o);
  Split of_select(const Operation& o);
  // The plain difference, for what has no rule.
  Split plain(Node node, double rest);
  double rest_of_variable(Variable variable) const;

  Graph& graph_;
  int dim_;
  std::unordered_map<Node, Split> known_;
};

}  // namespace isostretch::expressions
