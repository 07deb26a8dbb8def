#include "derivatives.hpp"

namespace isostretch::expressions {

// `node`: the function of the operand itself, which some derivatives are made of.
Node derivative_of_function(Graph& g, const Operation& o, Node node) {
  const Node a = o.a, one = g.constant(1);
  switch (o.op) {
    case Op::negate:
      return g.constant(-1);
    case Op::power:
      return g.scale(o.value, g.power(a, o.value - 1));
    case Op::sqrt:
      return g.scale(0.5, g.reciprocal(node));
    case Op::cbrt:
      return g.scale(1.0 / 3, g.reciprocal(g.multiply(node, node)));
    case Op::exp:
      return node;
    case Op::expm1:
      return g.unary(Op::exp, a);
    case Op::log:
      return g.reciprocal(a);
    case Op::log1p:
      return g.divide(one, g.add(one, a));
    case Op::sin:
      return g.unary(Op::cos, a);
    case Op::cos:
      return g.negate(g.unary(Op::sin, a));
    case Op::tan:
      return g.add(one, g.multiply(node, node));
    case Op::sinh:
      return g.unary(Op::cosh, a);
    case Op::cosh:
      return g.unary(Op::sinh, a);
    case Op::tanh:
      return g.subtract(one, g.multiply(node, node));
    case Op::atan:
      return g.divide(one, g.add(one, g.multiply(a, a)));
    case Op::abs:
      return g.unary(Op::sign, a);
    default:
      return g.constant(0);  // sign, conditions
  }
}

Node Derivatives::operator()(Node expression, Variable by) {
  auto& known = known_[static_cast<int>(by)];
  if (const auto found = known.find(expression); found != known.end()) return found->second;
  const Node result = derive(expression, by);
  known.emplace(expression, result);
  return result;
}

Node Derivatives::of_variable(Variable variable, Variable by) {
  if (variable == by) return graph_.constant(1);
  if (invariants_ == Invariants::independent || variable > Variable::I3) return graph_.constant(0);
  if (variable == Variable::I1) return graph_.constant(1);
  if (variable == Variable::I2) return graph_.scale(2, graph_.variable(by));
  Node others = graph_.constant(1);
  for (int axis = 0; axis < dim_; ++axis)
    if (stretch(axis) != by) others = graph_.multiply(others, graph_.variable(stretch(axis)));
  return others;
}

Node Derivatives::derive(Node expression, Variable by) {
  Graph& g = graph_;
  const Operation o = g[expression];  // by value: the graph grows
  Derivatives& D = *this;
  switch (o.op) {
    case Op::constant:
    case Op::less:
    case Op::less_equal:
    case Op::logical_and:
    case Op::logical_or:
    case Op::logical_not:
      return g.constant(0);
    case Op::variable:
      return of_variable(static_cast<Variable>(o.value), by);
    case Op::add:
      return g.add(D(o.a, by), D(o.b, by));
    case Op::subtract:
      return g.subtract(D(o.a, by), D(o.b, by));
    case Op::multiply: {
      const auto [base, exponent] = g.as_power(expression);
      if (exponent > 1)
        return g.multiply(g.scale(exponent, g.power(base, static_cast<double>(exponent - 1))), D(base, by));
      return g.add(g.multiply(D(o.a, by), o.b), g.multiply(o.a, D(o.b, by)));
    }
    case Op::divide:
      if (g.is_constant(o.a, 1)) return g.negate(g.multiply(g.multiply(expression, expression), D(o.b, by)));
      return g.divide(g.subtract(D(o.a, by), g.multiply(expression, D(o.b, by))), o.b);
    case Op::min:
      return g.select(g.binary(Op::less, o.a, o.b), D(o.a, by), D(o.b, by));
    case Op::max:
      return g.select(g.binary(Op::less, o.b, o.a), D(o.a, by), D(o.b, by));
    case Op::select:
      return g.select(o.a, D(o.b, by), D(o.c, by));
    default:
      return g.multiply(derivative_of_function(g, o, expression), D(o.a, by));
  }
}

std::vector<Node> partials(Graph& graph, Node psi, int dim) {
  using enum Variable;
  Derivatives D(graph, dim, Derivatives::Invariants::independent);
  const Node P1 = D(psi, I1), P2 = D(psi, I2), P3 = D(psi, I3);
  return {psi, P1, P2, P3, D(P1, I1), D(P2, I2), D(P3, I3), D(P1, I2), D(P2, I3), D(P1, I3)};
}

ExchangeDifferences::ExchangeDifferences(Graph& graph, int j, int k)
    : graph_(graph),
      j_(j),
      k_(k),
      gap_(graph.subtract(graph.variable(stretch(j)), graph.variable(stretch(k)))) {}

Node ExchangeDifferences::exchanged(Node expression) {
  if (const auto found = exchanged_.find(expression); found != exchanged_.end()) return found->second;
  const Operation o = graph_[expression];
  Node result = expression;
  switch (o.op) {
    case Op::constant:
      break;
    case Op::variable:
      if (o.value == static_cast<double>(stretch(j_))) result = graph_.variable(stretch(k_));
      if (o.value == static_cast<double>(stretch(k_))) result = graph_.variable(stretch(j_));
      break;
    case Op::select:
      result = graph_.select(exchanged(o.a), exchanged(o.b), exchanged(o.c));
      break;
    case Op::power:
      result = graph_.power(exchanged(o.a), o.value);
      break;
    case Op::multiply:
      if (const auto [base, exponent] = graph_.as_power(expression); exponent > 1) {
        result = graph_.power(exchanged(base), static_cast<double>(exponent));
        break;
      }
      [[fallthrough]];
    default:
      result = operand_count(o.op) == 2 ? graph_.binary(o.op, exchanged(o.a), exchanged(o.b))
                                        : graph_.unary(o.op, exchanged(o.a));
  }
  exchanged_.emplace(expression, result);
  return result;
}

Node ExchangeDifferences::operator()(Node expression) {
  if (const auto found = differences_.find(expression); found != differences_.end()) return found->second;
  const Node result = difference(expression);
  differences_.emplace(expression, result);
  return result;
}

Node ExchangeDifferences::difference(Node expression) {
  Graph& g = graph_;
  const Operation o = g[expression];
  ExchangeDifferences& D = *this;
  switch (o.op) {
    case Op::constant:
      return g.constant(0);
    case Op::variable:
      if (o.value == static_cast<double>(stretch(j_))) return g.constant(1);
      if (o.value == static_cast<double>(stretch(k_))) return g.constant(-1);
      return g.constant(0);
    case Op::add:
      return g.add(D(o.a), D(o.b));
    case Op::subtract:
      return g.subtract(D(o.a), D(o.b));
    case Op::multiply:
      return g.add(g.multiply(D(o.a), o.b), g.multiply(exchanged(o.a), D(o.b)));
    case Op::divide:
      if (g.is_constant(o.a, 1))
        return g.negate(g.multiply(g.multiply(expression, exchanged(expression)), D(o.b)));
      return g.divide(g.subtract(D(o.a), g.multiply(exchanged(expression), D(o.b))), o.b);
    case Op::negate:
      return g.negate(D(o.a));
    case Op::min:
    case Op::max: {
      // (a + b -+ |a - b|) / 2
      const Node spread = D(g.unary(Op::abs, g.subtract(o.a, o.b))), sum = g.add(D(o.a), D(o.b));
      return g.scale(0.5, o.op == Op::min ? g.subtract(sum, spread) : g.add(sum, spread));
    }
    case Op::select:
      return of_select(expression);
    case Op::sign:
    case Op::less:
    case Op::less_equal:
    case Op::logical_and:
    case Op::logical_or:
    case Op::logical_not:
      return plain(expression);
    default:
      break;
  }
  const Node slope = D(o.a);
  return g.multiply(of_function(o, slope), slope);
}

Node ExchangeDifferences::of_function(const Operation& o, Node slope) {
  Graph& g = graph_;
  const Node u = o.a, v = exchanged(u), one = g.constant(1), change = g.multiply(slope, gap_);
  const Node middle = g.scale(0.5, g.add(u, v)), half = g.scale(0.5, change);
  switch (o.op) {
    case Op::sqrt:
      return g.divide(one, g.add(g.unary(Op::sqrt, u), g.unary(Op::sqrt, v)));
    case Op::cbrt: {
      const Node a = g.unary(Op::cbrt, u), b = g.unary(Op::cbrt, v);
      return g.divide(one, g.add(g.add(g.multiply(a, a), g.multiply(a, b)), g.multiply(b, b)));
    }
    case Op::exp:
    case Op::expm1: {
      // From the larger of the two: the other factor is between 0 and 1.
      const Node down = g.negate(g.unary(Op::abs, change));
      return g.multiply(g.unary(Op::exp, g.binary(Op::max, u, v)), g.unary(Op::expm1_ratio, down));
    }
    case Op::log:
      return g.divide(g.unary(Op::log1p_ratio, g.divide(change, v)), v);
    case Op::log1p: {
      const Node w = g.add(one, v);
      return g.divide(g.unary(Op::log1p_ratio, g.divide(change, w)), w);
    }
    case Op::power: {
      // ((1 + t)^p - 1) / t = p expm1_ratio(p log1p(t)) log1p_ratio(t)
      const Node t = g.divide(change, v);
      const Node bent = g.unary(Op::expm1_ratio, g.scale(o.value, g.unary(Op::log1p, t)));
      const Node positive = g.multiply(g.scale(o.value, g.power(v, o.value - 1)),
                                       g.multiply(bent, g.unary(Op::log1p_ratio, t)));
      const Node zero = g.constant(0);
      const Node both = g.binary(Op::logical_and, g.binary(Op::less, zero, u), g.binary(Op::less, zero, v));
      return g.select(both, positive, by_middle(o, change));
    }
    // sin u - sin v = 2 cos((u + v)/2) sin((u - v)/2), and so on.
    case Op::sin:
      return g.multiply(g.unary(Op::cos, middle), over_operand(Op::sin, half));
    case Op::cos:
      return g.negate(g.multiply(g.unary(Op::sin, middle), over_operand(Op::sin, half)));
    case Op::sinh:
      return g.multiply(g.unary(Op::cosh, middle), over_operand(Op::sinh, half));
    case Op::cosh:
      return g.multiply(g.unary(Op::sinh, middle), over_operand(Op::sinh, half));
    case Op::tan:
      return g.multiply(g.add(one, g.multiply(g.unary(Op::tan, u), g.unary(Op::tan, v))),
                        over_operand(Op::tan, change));
    case Op::tanh:
      return g.multiply(g.subtract(one, g.multiply(g.unary(Op::tanh, u), g.unary(Op::tanh, v))),
                        over_operand(Op::tanh, change));
    case Op::atan: {
      const Node below = g.add(one, g.multiply(u, v));  // not positive: u and v are far apart
      const Node near = g.divide(over_operand(Op::atan, g.divide(change, below)), below);
      return g.select(g.binary(Op::less, g.constant(0), below), near, secant(o, change));
    }
    case Op::abs: {
      constexpr double tiny = 1e-300;
      const Node size = g.add(g.unary(Op::abs, u), g.unary(Op::abs, v));
      return g.divide(g.add(u, v), g.binary(Op::max, size, g.constant(tiny)));
    }
    default:
      return secant(o, change);  // no other function is there
  }
}

// With the condition c and the exchanged one c*: by branch where they agree, as they do wherever s_j and s_k
// are equal.
Node ExchangeDifferences::of_select(Node expression) {
  Graph& g = graph_;
  const Operation o = g[expression];
  const Node condition = o.a, other = exchanged(condition), first = (*this)(o.b), second = (*this)(o.c);
  if (other == condition) return g.select(condition, first, second);
  const Node agreed = g.select(condition, first, second);
  const Node differ = g.subtract(condition, other);
  return g.select(differ, g.select(gap_, plain(expression), agreed), agreed);
}

Node ExchangeDifferences::plain(Node expression) {
  const Node change = graph_.subtract(expression, exchanged(expression));
  return graph_.select(gap_, graph_.divide(change, gap_), graph_.constant(0));
}

Node ExchangeDifferences::over_operand(Op op, Node x) {
  return graph_.select(x, graph_.quotient(graph_.unary(op, x), x), graph_.constant(1));
}

Node ExchangeDifferences::secant(const Operation& o, Node change) {
  Graph& g = graph_;
  const Node v = exchanged(o.a);
  const Node f = o.op == Op::power ? g.power(o.a, o.value) : g.unary(o.op, o.a),
             fv = o.op == Op::power ? g.power(v, o.value) : g.unary(o.op, v);
  return g.divide(g.subtract(f, fv), change);
}

Node ExchangeDifferences::by_middle(const Operation& o, Node change) {
  // What the tangent leaves out is the square of this; the rounding of a quotient is the inverse.
  constexpr double near = 1e-5;
  Graph& g = graph_;
  const Node middle = g.scale(0.5, g.add(o.a, exchanged(o.a)));
  const Node tangent = g.scale(o.value, g.power(middle, o.value - 1));
  return g.select(g.binary(Op::less, g.constant(near), g.unary(Op::abs, change)), secant(o, change), tangent);
}

}  // namespace isostretch::expressions
