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

  bool exist_in(int dim) const { return !stretches || third_stretch == (dim == 3); }
  bool only_invariants() const { return !stretches && !sum; }
};

// Reads a text (expression.hpp) as an expression of that dimension into the graph. Throws ExpressionError.
Node parse(std::string_view text, int dim, const std::map<std::string, double>& parameters, Graph& graph,
           Mentions& mentions);

// The same with parameters as variables, parameter(i) the i-th of these names.
Node parse_with_names(std::string_view text, int dim, const std::set<std::string>& parameters, Graph& graph,
                      Mentions& mentions);

// As the parser knows it; empty for what is no function of one number.
std::string_view function_name(Op op);

}  // namespace isostretch::expressions
