#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace isostretch::expressions {

enum class Op : std::uint8_t {
  constant,
  variable,
  excess,  // of a variable over its value at rest, without cancellation
  add,
  subtract,
  multiply,
  divide,
  negate,
  power,  // the exponent is a constant, in `value`
  sqrt,
  cbrt,
  exp,
  expm1,
  log,
  log1p,
  sin,
  cos,
  tan,
  sinh,
  cosh,
  tanh,
  atan,
  abs,
  sign,  // -1, 0, 1
  min,
  max,
  expm1_ratio,  // expm1(x) / x, 1 at 0
  log1p_ratio,  // log1p(x) / x, 1 at 0
  less,         // conditions are 1 and 0
  less_equal,
  logical_and,
  logical_or,
  logical_not,
  select,  // a != 0 ? b : c
  // Of programs only, where a product is needed for nothing but a sum: a b + c, a b - c, c - a b.
  multiply_add,
  multiply_subtract,
  subtract_product
};

// 0 to 3.
int operand_count(Op op);

// What an expression is made of besides numbers. In the plane s3 does not occur.
// Beyond these are parameters, where they are kept by name.
enum class Variable : std::uint16_t { I1, I2, I3, s1, s2, s3 };
constexpr Variable stretch(int axis) {
  return static_cast<Variable>(static_cast<int>(Variable::s1) + axis);
}
constexpr Variable parameter(int number) {
  return static_cast<Variable>(static_cast<int>(Variable::s3) + 1 + number);
}

using Node = std::uint32_t;

struct Operation {
  Op op = Op::constant;
  Node a = 0, b = 0, c = 0;  // operands
  double value = 0;          // constant, power; number of a variable, for its excess, too
  bool operator==(const Operation& other) const;
};

// Expressions that share what they have in common: an operation on the same operands is the same node.
// Building one does arithmetic on constants and leaves out what changes nothing. Throws Error beyond
// max_nodes.
class Graph {
 public:
  // From here on what is multiplied by zero, or subtracted from itself, counts as finite: right for
  // derivatives, of which nothing is asked elsewhere, and not for what a user wrote.
  void assume_finite() { assumes_finite_ = true; }
  // That, and from here on sums and products are rearranged to save operations: numbers are gathered, common
  // factors taken out of sums. Right up to rounding, and to overflow on the way, which is why what a user
  // wrote is left alone.
  void save_operations() { assumes_finite_ = saves_operations_ = true; }

  const Operation& operator[](Node node) const { return nodes_[node]; }
  std::size_t size() const { return nodes_.size(); }

  Node constant(double value);
  Node variable(Variable v);
  Node excess(Variable v);
  Node unary(Op op, Node a);
  Node binary(Op op, Node a, Node b);
  Node select(Node condition, Node a, Node b);
  Node power(Node a, double exponent);
  Node power(Node a, Node exponent);

  Node add(Node a, Node b) { return binary(Op::add, a, b); }
  Node subtract(Node a, Node b) { return binary(Op::subtract, a, b); }
  Node multiply(Node a, Node b) { return binary(Op::multiply, a, b); }
  Node divide(Node a, Node b) { return binary(Op::divide, a, b); }
  Node negate(Node a) { return unary(Op::negate, a); }
  Node scale(double factor, Node a) { return multiply(constant(factor), a); }
  // A division that is not rearranged: for quotients of what may be too small to divide by alone.
  Node quotient(Node a, Node b) { return intern({Op::divide, a, b, 0, 0}); }
  // 1 / a, and (1 / u)^n for what is known as u^n.
  Node reciprocal(Node a);

  // base^exponent with an exponent of 2 to 16, where a node is known to be that; itself^1 else.
  struct WholePower {
    Node base;
    int exponent;
  };
  WholePower as_power(Node a) const;

  bool is_constant(Node a) const { return nodes_[a].op == Op::constant; }
  bool is_constant(Node a, double value) const { return is_constant(a) && nodes_[a].value == value; }

 private:
  struct Hash {
    std::size_t operator()(const Operation& operation) const noexcept;
  };
  Node intern(const Operation& operation);
  Node intern_sum(Node a, Node b);
  Node intern_product(Node a, Node b);
  Node product(Node a, Node b);
  Node whole_power_of(Node a, int exponent);

  // rearrangement.cpp
  struct Scaled {
    double factor;
    Node node;
  };
  Scaled split(Node a);
  Node scaled(const Scaled& a);
  Node rearranged_product(Node a, Node b);
  Node rearranged_sum(Node a, double sign, Node b);
  bool collect_factors(Node product, std::vector<Node>& found) const;
  std::optional<Node> common_factor(Node a, Node b) const;
  std::optional<Node> without(Node product, Node factor);

  static constexpr int largest_whole_power = 16;

  bool assumes_finite_ = false, saves_operations_ = false;
  std::vector<Operation> nodes_;
  std::unordered_map<Operation, Node, Hash> index_;
  std::unordered_map<Node, WholePower> whole_powers_;
  std::unordered_set<Node> bases_;  // of those
};

// What one operation makes of numbers: the meaning of Op, for constants and for evaluation one by one.
double apply(const Operation& operation, double a, double b, double c);

}  // namespace isostretch::expressions
