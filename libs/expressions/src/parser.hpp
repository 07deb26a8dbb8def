#pragma once

#include "graph.hpp"

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace isostretch::expressions {

// Which of the variables a text mentions, and which parameters.
struct Mentions {
  bool invariants = false;
  bool stretches = false;  // s1, s2 or s3
  bool third_stretch = false;
  bool sum = false;
  std::set<std::string> parameters;
};

// Reads a text (expression.hpp) as an expression of that dimension into the graph. Throws ExpressionError.
Node parse(std::string_view text, int dim, const std::map<std::string, double>& parameters, Graph& graph,
           Mentions& mentions);

}  // namespace isostretch::expressions
