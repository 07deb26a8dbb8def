#pragma once

#include "graph.hpp"

#include <unordered_map>
#include <vector>

namespace isostretch::expressions {

// Partial derivatives of expressions of one graph, by one of its variables each. With invariants as
// independent variables (for partials of psi by them), or as functions of the stretches.
class Derivatives {
 public:
  enum class Invariants { independent, of_stretches };
  Derivatives(Graph& graph, int dim, Invariants invariants)
      : graph_(graph), dim_(dim), invariants_(invariants) {}

  Node operator()(Node expression, Variable by);

 private:
  Node derive(Node expression, Variable by);
  Node of_variable(Variable variable, Variable by);

  Graph& graph_;
  int dim_;
  Invariants invariants_;
  std::unordered_map<Node, Node> known_[6];  // by variable
};

// psi, P1, P2, P3, P11, P22, P33, P12, P23, P13 of an expression in invariants.
std::vector<Node> partials(Graph& graph, Node psi, int dim);

// Divided differences by exchanging two stretches,
//   D[u] = (u(.., s_j, .., s_k, ..) - u(.., s_k, .., s_j, ..)) / (s_j - s_k),
// by rules that do not cancel where s_j and s_k are equal, or nearly so: D[u v] = D[u] v + u* D[v] with u*
// the exchanged u, D[f(u)] = f[u, u*] D[u] with the divided difference of f. The flip eigenvalue of a pair is
// D of the derivative by s_j.
class ExchangeDifferences {
 public:
  ExchangeDifferences(Graph& graph, int j, int k);

  Node operator()(Node expression);
  Node exchanged(Node expression);

 private:
  Node difference(Node expression);
  // f[u, u*] for u* = u - slope (s_j - s_k).
  Node of_function(const Operation& operation, Node slope);
  // The plain quotient, for what has no rule: not differentiable along the way.
  Node plain(Node expression);
  Node of_select(Node expression);
  // f(x) / x, 1 at 0.
  Node over_operand(Op op, Node x);
  // (f[u] - f[u*]) / change, for operands that are far apart.
  Node secant(const Operation& operation, Node change);
  // Of powers of what need not be positive: by the slope in the middle where u and u* are near.
  Node by_middle(const Operation& operation, Node change);

  Graph& graph_;
  int j_, k_;
  Node gap_;  // s_j - s_k
  std::unordered_map<Node, Node> exchanged_, differences_;
};

// Derivative of a function of one operand, at that operand.
Node derivative_of_function(Graph& graph, const Operation& operation, Node node);

}  // namespace isostretch::expressions
