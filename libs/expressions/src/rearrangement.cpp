// Sums and products of derivatives, with fewer operations than the rules of differentiation give them.
#include "graph.hpp"

#include <algorithm>
#include <cmath>

namespace isostretch::expressions {

// factor * node, node not a multiple of something itself unless the factor would overflow or vanish; a number
// is a multiple of the node 1.
Graph::Scaled Graph::split(Node a) {
  double factor = 1;
  for (;;) {
    const Operation& o = nodes_[a];
    if (o.op == Op::constant) return {factor * o.value, constant(1)};
    if (o.op == Op::negate) {
      factor = -factor;
      a = o.a;
      continue;
    }
    if (o.op != Op::multiply || is_constant(o.a) == is_constant(o.b)) return {factor, a};
    const double next = factor * nodes_[is_constant(o.a) ? o.a : o.b].value;
    if (!std::isnormal(next)) return {factor, a};
    factor = next;
    a = is_constant(o.a) ? o.b : o.a;
  }
}

Node Graph::scaled(const Scaled& a) {
  if (is_constant(a.node, 1)) return constant(a.factor);
  if (a.factor == 0) return constant(0);
  if (a.factor == 1) return a.node;
  if (a.factor == -1) return intern({Op::negate, a.node, 0, 0, 0});
  return intern_product(constant(a.factor), a.node);
}

// Numbers come first, and powers of the same base become one.
Node Graph::rearranged_product(Node a, Node b) {
  const Scaled p = split(a), q = split(b);
  const double factor = p.factor * q.factor;
  if (!std::isnormal(factor)) return intern_product(a, b);  // too large or too small for one number
  if (is_constant(p.node, 1)) return scaled({factor, q.node});
  if (is_constant(q.node, 1)) return scaled({factor, p.node});
  const WholePower first = as_power(p.node), second = as_power(q.node);
  const int exponent = first.exponent + second.exponent;
  if (first.base == second.base && exponent <= largest_whole_power)
    return scaled({factor, whole_power_of(first.base, exponent)});
  return scaled({factor, intern_product(p.node, q.node)});
}

// a + b and, with sign -1, a - b: x y + x z = x (y + z), and numbers gathered.
Node Graph::rearranged_sum(Node a, double sign, Node b) {
  Scaled p = split(a), q = split(b);
  q.factor *= sign;
  if (p.node == q.node && std::isfinite(p.factor + q.factor)) return scaled({p.factor + q.factor, p.node});
  Node common = constant(1);
  while (const auto factor = common_factor(p.node, q.node)) {
    const auto rest_of_p = without(p.node, *factor), rest_of_q = without(q.node, *factor);
    if (!rest_of_p || !rest_of_q) break;  // a product on the way has got powers meanwhile
    p.node = *rest_of_p, q.node = *rest_of_q;
    common = multiply(common, *factor);
  }
  if (!is_constant(common, 1)) return multiply(rearranged_sum(scaled(p), 1, scaled(q)), common);
  const bool is_multiple = !is_constant(p.node, 1) && !is_constant(q.node, 1) &&
                           std::abs(p.factor) == std::abs(q.factor) && std::abs(p.factor) != 1;
  if (is_multiple) return scaled({p.factor, rearranged_sum(p.node, q.factor / p.factor, q.node)});
  // One node for a sum and its negative.
  if (p.factor < 0 && q.factor < 0)
    return scaled({-1, rearranged_sum(scaled({-p.factor, p.node}), 1, scaled({-q.factor, q.node}))});
  if (q.factor < 0) return intern({Op::subtract, scaled(p), scaled({-q.factor, q.node}), 0, 0});
  if (p.factor < 0) return intern({Op::subtract, scaled(q), scaled({-p.factor, p.node}), 0, 0});
  return intern_sum(scaled(p), scaled(q));
}

// All that a product is a product of, with the products on the way. What has powers stays whole: y = a b in a
// sum of powers of y. False: more than the budget.
bool Graph::collect_factors(Node product, std::vector<Node>& found) const {
  constexpr std::size_t budget = 32;
  if (found.size() == budget) return false;
  found.push_back(product);
  const Operation& o = nodes_[product];
  if (o.op != Op::multiply || bases_.contains(product)) return true;
  return collect_factors(o.a, found) && collect_factors(o.b, found);
}

// The largest one found, if there is any but numbers.
std::optional<Node> Graph::common_factor(Node a, Node b) const {
  std::vector<Node> of_a, of_b;
  if (!collect_factors(a, of_a) || !collect_factors(b, of_b)) return std::nullopt;
  for (const Node factor : of_a)
    if (!is_constant(factor) && std::find(of_b.begin(), of_b.end(), factor) != of_b.end()) return factor;
  return std::nullopt;
}

// Nothing where it is no factor that is found above.
std::optional<Node> Graph::without(Node product, Node factor) {
  if (product == factor) return constant(1);
  const Operation o = nodes_[product];
  if (o.op != Op::multiply || bases_.contains(product)) return std::nullopt;
  if (const auto rest = without(o.a, factor)) return multiply(*rest, o.b);
  if (const auto rest = without(o.b, factor)) return multiply(o.a, *rest);
  return std::nullopt;
}

}  // namespace isostretch::expressions
