#include "rest_difference.hpp"

#include <cmath>

namespace isostretch::expressions {

std::optional<Node> RestDifferences::operator()(Node expression) {
  const Split split = this->split(expression);
  if (!std::isfinite(split.rest)) return std::nullopt;
  return graph_.add(graph_.constant(split.rest), split.difference);
}

RestDifferences::Split RestDifferences::split(Node node) {
  if (const auto found = known_.find(node); found != known_.end()) return found->second;
  const Split result = made(node);
  known_.emplace(node, result);
  return result;
}

double RestDifferences::rest_of_variable(Variable variable) const {
  return variable == Variable::I1 || variable == Variable::I2 ? dim_ : 1;
}

RestDifferences::Split RestDifferences::made(Node node) {
  const Operation o = graph_[node];  // a copy: nodes are added
  switch (o.op) {
    case Op::constant:
      return {o.value, graph_.constant(0)};
    case Op::variable: {
      const auto variable = static_cast<Variable>(static_cast<int>(o.value));
      return {rest_of_variable(variable), graph_.excess(variable)};
    }
    case Op::add:
      return of_sum(o, 1);
    case Op::subtract:
      return of_sum(o, -1);
    case Op::multiply:
      return of_product(o);
    case Op::divide:
      return of_quotient(node, o);
    case Op::negate: {
      const Split a = split(o.a);
      return {-a.rest, graph_.negate(a.difference)};
    }
    case Op::select:
      return of_select(o);
    default:
      return of_function(node, o);
  }
}

RestDifferences::Split RestDifferences::plain(Node node, double rest) {
  return {rest, graph_.subtract(node, graph_.constant(rest))};
}

RestDifferences::Split RestDifferences::of_sum(const Operation& o, double sign) {
  const Split a = split(o.a), b = split(o.b);
  return {a.rest + sign * b.rest,
          sign > 0 ? graph_.add(a.difference, b.difference) : graph_.subtract(a.difference, b.difference)};
}

RestDifferences::Split RestDifferences::of_product(const Operation& o) {
  const Split a = split(o.a), b = split(o.b);
  const Node first = graph_.add(graph_.scale(a.rest, b.difference), graph_.scale(b.rest, a.difference));
  return {a.rest * b.rest, graph_.add(first, graph_.multiply(a.difference, b.difference))};
}

// a / b - a0 / b0 = ((a - a0) - a0 / b0 (b - b0)) / b.
RestDifferences::Split RestDifferences::of_quotient(Node node, const Operation& o) {
  const Split a = split(o.a), b = split(o.b);
  const double rest = a.rest / b.rest;
  if (!std::isfinite(rest)) return plain(node, rest);
  const Node change = graph_.subtract(a.difference, graph_.scale(rest, b.difference));
  return {rest, graph_.divide(change, o.b)};
}

RestDifferences::Split RestDifferences::of_function(Node node, const Operation& o) {
  const int operands = operand_count(o.op);
  const Split a = split(o.a), b = operands > 1 ? split(o.b) : Split{0, 0},
              c = operands > 2 ? split(o.c) : Split{0, 0};
  const double rest = apply(o, a.rest, b.rest, c.rest);
  const auto relative = [&](double value) { return graph_.scale(1 / value, a.difference); };
  const auto log1p = [&](Node x) { return graph_.unary(Op::log1p, x); };
  const auto expm1 = [&](Node x) { return graph_.unary(Op::expm1, x); };
  switch (o.op) {
    case Op::exp:
    case Op::expm1:
      return {rest, graph_.scale(std::exp(a.rest), expm1(a.difference))};
    case Op::log:
      return a.rest > 0 ? Split{rest, log1p(relative(a.rest))} : plain(node, rest);
    case Op::log1p:
      return a.rest > -1 ? Split{rest, log1p(relative(1 + a.rest))} : plain(node, rest);
    case Op::sqrt:
      if (!(a.rest > 0)) return plain(node, rest);
      return {rest, graph_.divide(a.difference, graph_.add(node, graph_.constant(rest)))};
    case Op::power:
    case Op::cbrt: {
      if (!(a.rest > 0)) return plain(node, rest);
      const double exponent = o.op == Op::cbrt ? 1.0 / 3.0 : o.value;
      return {rest, graph_.scale(rest, expm1(graph_.scale(exponent, log1p(relative(a.rest)))))};
    }
    default:
      return plain(node, rest);
  }
}

// Which of the two it is, is decided where it is evaluated.
RestDifferences::Split RestDifferences::of_select(const Operation& o) {
  const Split condition = split(o.a), b = split(o.b), c = split(o.c);
  const double rest = condition.rest != 0 ? b.rest : c.rest;
  const auto from_rest = [&](const Split& part) {
    return graph_.add(graph_.constant(part.rest - rest), part.difference);
  };
  return {rest, graph_.select(o.a, from_rest(b), from_rest(c))};
}

}  // namespace isostretch::expressions
