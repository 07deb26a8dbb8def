#include "graph.hpp"

#include <isostretch/expressions/expression.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <utility>

namespace isostretch::expressions {
namespace {

bool commutes(Op op) {
  return op == Op::add || op == Op::multiply || op == Op::min || op == Op::max || op == Op::logical_and ||
         op == Op::logical_or;
}

}  // namespace

int operand_count(Op op) {
  switch (op) {
    case Op::constant:
    case Op::variable:
    case Op::excess:
      return 0;
    case Op::add:
    case Op::subtract:
    case Op::multiply:
    case Op::divide:
    case Op::min:
    case Op::max:
    case Op::less:
    case Op::less_equal:
    case Op::logical_and:
    case Op::logical_or:
      return 2;
    case Op::select:
    case Op::multiply_add:
    case Op::multiply_subtract:
    case Op::subtract_product:
      return 3;
    default:
      return 1;
  }
}

bool Operation::operator==(const Operation& other) const {
  // By bits: -0 is not 0, and NaN is itself.
  return op == other.op && a == other.a && b == other.b && c == other.c &&
         std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(other.value);
}

std::size_t Graph::Hash::operator()(const Operation& o) const noexcept {
  std::uint64_t hash = static_cast<std::uint64_t>(o.op);
  for (const std::uint64_t part :
       {std::uint64_t{o.a}, std::uint64_t{o.b}, std::uint64_t{o.c}, std::bit_cast<std::uint64_t>(o.value)})
    hash = (hash ^ (part + 0x9e3779b97f4a7c15ull + (hash << 6) + (hash >> 2))) * 0xff51afd7ed558ccdull;
  return static_cast<std::size_t>(hash ^ (hash >> 32));
}

Node Graph::intern(const Operation& operation) {
  const auto [found, is_new] = index_.try_emplace(operation, static_cast<Node>(nodes_.size()));
  if (is_new) {
    if (nodes_.size() >= max_nodes)
      throw Error("the expression, or its derivatives, have more than " + std::to_string(max_nodes) +
                  " operations");
    nodes_.push_back(operation);
  }
  return found->second;
}

Node Graph::intern_sum(Node a, Node b) {
  return intern({Op::add, std::min(a, b), std::max(a, b), 0, 0});
}

Node Graph::intern_product(Node a, Node b) {
  const Node product = intern({Op::multiply, std::min(a, b), std::max(a, b), 0, 0});
  if (a == b) {
    whole_powers_.try_emplace(product, WholePower{a, 2});
    bases_.insert(a);
  }
  return product;
}

// Of two numbers in a row one is made.
Node Graph::product(Node a, Node b) {
  for (const auto& [number, other] : {std::pair{a, b}, std::pair{b, a}}) {
    const Operation& o = nodes_[other];
    if (!is_constant(number) || o.op != Op::multiply || is_constant(o.a) == is_constant(o.b)) continue;
    const double factor = nodes_[number].value * nodes_[is_constant(o.a) ? o.a : o.b].value;
    if (std::isnormal(factor)) return intern_product(constant(factor), is_constant(o.a) ? o.b : o.a);
  }
  return intern_product(a, b);
}

Graph::WholePower Graph::as_power(Node a) const {
  const auto found = whole_powers_.find(a);
  return found == whole_powers_.end() ? WholePower{a, 1} : found->second;
}

Node Graph::reciprocal(Node a) {
  const WholePower power = as_power(a);
  if (power.exponent == 1) return divide(constant(1), a);
  return whole_power_of(divide(constant(1), power.base), power.exponent);
}

Node Graph::constant(double value) {
  return intern({Op::constant, 0, 0, 0, value});
}

Node Graph::variable(Variable v) {
  return intern({Op::variable, 0, 0, 0, static_cast<double>(v)});
}

Node Graph::excess(Variable v) {
  return intern({Op::excess, 0, 0, 0, static_cast<double>(v)});
}

Node Graph::unary(Op op, Node a) {
  const Operation operation{op, a, 0, 0, 0};
  if (is_constant(a)) return constant(apply(operation, nodes_[a].value, 0, 0));
  if (op == Op::negate && nodes_[a].op == Op::negate) return nodes_[a].a;
  if (op == Op::negate && saves_operations_) {
    const Scaled split_up = split(a);
    return scaled({-split_up.factor, split_up.node});
  }
  return intern(operation);
}

Node Graph::binary(Op op, Node a, Node b) {
  if (commutes(op) && b < a) std::swap(a, b);
  const Operation operation{op, a, b, 0, 0};
  if (is_constant(a) && is_constant(b))
    return constant(apply(operation, nodes_[a].value, nodes_[b].value, 0));
  switch (op) {
    case Op::add:
      if (is_constant(a, 0)) return b;
      if (is_constant(b, 0)) return a;
      if (nodes_[b].op == Op::negate) return subtract(a, nodes_[b].a);
      if (nodes_[a].op == Op::negate) return subtract(b, nodes_[a].a);
      if (saves_operations_) return rearranged_sum(a, 1, b);
      break;
    case Op::subtract:
      if (assumes_finite_ && a == b) return constant(0);
      if (is_constant(b, 0)) return a;
      if (is_constant(a, 0)) return negate(b);
      if (nodes_[b].op == Op::negate) return add(a, nodes_[b].a);
      if (saves_operations_) return rearranged_sum(a, -1, b);
      break;
    case Op::multiply:
      if (assumes_finite_ && (is_constant(a, 0) || is_constant(b, 0))) return constant(0);
      if (is_constant(a, 1)) return b;
      if (is_constant(b, 1)) return a;
      if (is_constant(a, -1)) return negate(b);
      if (is_constant(b, -1)) return negate(a);
      return saves_operations_ ? rearranged_product(a, b) : product(a, b);
    case Op::divide:
      if (assumes_finite_ && is_constant(a, 0)) return a;
      if (is_constant(b, 1)) return a;
      if (is_constant(b) && std::isnormal(1 / nodes_[b].value))
        return multiply(constant(1 / nodes_[b].value), a);
      if (as_power(b).exponent > 1 || (saves_operations_ && !is_constant(a, 1)))
        return multiply(a, reciprocal(b));
      break;
    case Op::min:
    case Op::max:
      if (a == b) return a;
      break;
    default:
      break;
  }
  return intern(operation);
}

Node Graph::select(Node condition, Node a, Node b) {
  if (a == b) return a;
  if (is_constant(condition)) return nodes_[condition].value != 0 ? a : b;
  return intern({Op::select, condition, a, b, 0});
}

// Small whole powers by multiplication: exact where pow() is not, and many times faster.
Node Graph::power(Node a, double exponent) {
  if (exponent == 0) return constant(1);
  if (exponent == 1) return a;
  if (is_constant(a)) return constant(std::pow(nodes_[a].value, exponent));
  if (exponent == 0.5) return unary(Op::sqrt, a);
  if (exponent == -0.5) return divide(constant(1), unary(Op::sqrt, a));
  if (exponent == std::floor(exponent) && std::abs(exponent) <= largest_whole_power) {
    const int whole = static_cast<int>(exponent);
    return whole > 0 ? whole_power_of(a, whole) : whole_power_of(reciprocal(a), -whole);
  }
  return intern({Op::power, a, 0, 0, exponent});
}

Node Graph::whole_power_of(Node a, int exponent) {
  if (exponent == 1) return a;
  const WholePower known = as_power(a);
  if (known.exponent > 1 && known.exponent * exponent <= largest_whole_power)
    return whole_power_of(known.base, known.exponent * exponent);
  const Node half = whole_power_of(a, exponent / 2), even = intern_product(half, half);
  const Node result = exponent % 2 == 0 ? even : intern_product(even, a);
  whole_powers_.insert_or_assign(result, WholePower{a, exponent});
  return result;
}

Node Graph::power(Node a, Node exponent) {
  if (is_constant(exponent)) return power(a, nodes_[exponent].value);
  return unary(Op::exp, multiply(exponent, unary(Op::log, a)));
}

double apply(const Operation& operation, double a, double b, double c) {
  switch (operation.op) {
    case Op::constant:
    case Op::variable:
    case Op::excess:
      return operation.value;
    case Op::add:
      return a + b;
    case Op::subtract:
      return a - b;
    case Op::multiply:
      return a * b;
    case Op::divide:
      return a / b;
    case Op::negate:
      return -a;
    case Op::power:
      return std::pow(a, operation.value);
    case Op::sqrt:
      return std::sqrt(a);
    case Op::cbrt:
      return std::cbrt(a);
    case Op::exp:
      return std::exp(a);
    case Op::expm1:
      return std::expm1(a);
    case Op::log:
      return std::log(a);
    case Op::log1p:
      return std::log1p(a);
    case Op::sin:
      return std::sin(a);
    case Op::cos:
      return std::cos(a);
    case Op::tan:
      return std::tan(a);
    case Op::sinh:
      return std::sinh(a);
    case Op::cosh:
      return std::cosh(a);
    case Op::tanh:
      return std::tanh(a);
    case Op::atan:
      return std::atan(a);
    case Op::abs:
      return std::abs(a);
    case Op::sign:
      return a > 0 ? 1 : a < 0 ? -1 : a;
    case Op::min:
      return a < b ? a : b <= a ? b : a + b;  // a NaN goes on
    case Op::max:
      return a > b ? a : b >= a ? b : a + b;
    case Op::expm1_ratio:
      return a == 0 ? 1 : std::expm1(a) / a;
    case Op::log1p_ratio:
      return a == 0 ? 1 : std::log1p(a) / a;
    case Op::less:
      return a < b;
    case Op::less_equal:
      return a <= b;
    case Op::logical_and:
      return a != 0 && b != 0;
    case Op::logical_or:
      return a != 0 || b != 0;
    case Op::logical_not:
      return a == 0;
    case Op::select:
      return a != 0 ? b : c;
    case Op::multiply_add:
      return a * b + c;
    case Op::multiply_subtract:
      return a * b - c;
    case Op::subtract_product:
      return c - a * b;
  }
  return 0;
}

}  // namespace isostretch::expressions
