#include "program.hpp"

#include <isostretch/core/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace isostretch::expressions {
namespace {

class Compiler {
 public:
  explicit Compiler(const Graph& graph) {
    for (Node node = 0; node < graph.size(); ++node) operations_.push_back(graph[node]);
  }

  Program run(const std::vector<Node>& outputs) {
    fuse(outputs);
    find_last_uses(outputs);
    // Nodes are in an order in which operands come first.
    for (Node node = 0; node < operations_.size(); ++node)
      if (last_use_[node] >= 0) emit(node);
    for (const Node output : outputs) program_.results.push_back(register_of_[output]);
    return std::move(program_);
  }

 private:
  bool is_constant(Node node) const { return operations_[node].op == Op::constant; }
  bool is_power_of_two(Node constant) const {
    int exponent;
    return std::abs(std::frexp(operations_[constant].value, &exponent)) == 0.5;
  }

  // psi comes out as without fusing, by itself and beside its derivatives: in it only multiples by powers of
  // two are fused, which are exact.
  void fuse(const std::vector<Node>& outputs) {
    const std::vector<int> uses = count_uses(outputs), uses_in_psi = count_uses({outputs.front()});
    for (Node node = 0; node < operations_.size(); ++node) {
      Operation& o = operations_[node];
      if (uses[node] == 0 || (o.op != Op::add && o.op != Op::subtract)) continue;
      const bool in_psi = uses_in_psi[node] > 0;
      const auto may_vanish = [&](Node product, Node other) {
        const Operation& m = operations_[product];
        if (m.op != Op::multiply || (in_psi ? uses_in_psi : uses)[product] != 1) return false;
        if (is_constant(m.a) || is_constant(m.b))
          return !is_constant(other) && (!in_psi || is_power_of_two(is_constant(m.a) ? m.a : m.b));
        return !in_psi;
      };
      if (may_vanish(o.a, o.b))
        o = fused(o.op == Op::add ? Op::multiply_add : Op::multiply_subtract, o.a, o.b);
      else if (may_vanish(o.b, o.a))
        o = fused(o.op == Op::add ? Op::multiply_add : Op::subtract_product, o.b, o.a);
    }
  }

  // A number among the factors comes second.
  Operation fused(Op op, Node product, Node other) const {
    const Operation& m = operations_[product];
    return is_constant(m.a) ? Operation{op, m.b, m.a, other, 0} : Operation{op, m.a, m.b, other, 0};
  }

  std::vector<int> count_uses(const std::vector<Node>& outputs) const {
    std::vector<int> uses(operations_.size(), 0);
    for (const Node output : outputs) ++uses[output];
    for (Node node = static_cast<Node>(operations_.size()); node-- > 0;) {
      if (uses[node] == 0) continue;
      const Operation& o = operations_[node];
      const Node all[] = {o.a, o.b, o.c};
      // NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): no operation has more operands than three
      for (int i = 0; i < operand_count(o.op); ++i) ++uses[all[i]];
    }
    return uses;
  }

  void find_last_uses(const std::vector<Node>& outputs) {
    last_use_.assign(operations_.size(), -1);
    register_of_.assign(operations_.size(), 0);
    for (const Node output : outputs) last_use_[output] = std::numeric_limits<int>::max();
    for (Node node = static_cast<Node>(operations_.size()); node-- > 0;) {
      if (last_use_[node] < 0) continue;
      for (const Node operand : operands(node))
        last_use_[operand] = std::max(last_use_[operand], static_cast<int>(node));
    }
  }

  // One operand may be a number: it needs no register then.
  Instruction::Immediate immediate(const Operation& o) const {
    const int count = operand_count(o.op);
    if (count < 2 || o.op == Op::select) return Instruction::Immediate::none;
    if (is_constant(o.b)) return Instruction::Immediate::second;
    if (count == 3) return is_constant(o.c) ? Instruction::Immediate::third : Instruction::Immediate::none;
    return is_constant(o.a) ? Instruction::Immediate::first : Instruction::Immediate::none;
  }

  // Those that are in registers.
  std::vector<Node> operands(Node node) const {
    const Operation& o = operations_[node];
    const int number = static_cast<int>(immediate(o)) - static_cast<int>(Instruction::Immediate::first);
    const Node all[] = {o.a, o.b, o.c};
    std::vector<Node> read;
    for (int i = 0; i < operand_count(o.op); ++i)
      if (i != number) read.push_back(all[i]);
    return read;
  }

  void emit(Node node) {
    const Operation& o = operations_[node];
    const Node all[] = {o.a, o.b, o.c};
    const auto read = [&](int i) {
      return i < operand_count(o.op) ? register_of_[all[i]] : std::uint16_t{0};
    };
    Instruction instruction{o.op, immediate(o), 0, read(0), read(1), read(2), o.value};
    if (instruction.immediate != Instruction::Immediate::none) {
      const int number =
          static_cast<int>(instruction.immediate) - static_cast<int>(Instruction::Immediate::first);
      instruction.value = operations_[all[number]].value;
    }
    // Every operation reads an entry before it writes it: the result may take an operand's place.
    for (const Node operand : operands(node))
      if (last_use_[operand] == static_cast<int>(node)) release(register_of_[operand]);
    instruction.to = register_of_[node] = acquire();
    program_.code.push_back(instruction);
  }

  void release(std::uint16_t r) {
    if (std::find(free_.begin(), free_.end(), r) == free_.end()) free_.push_back(r);
  }

  std::uint16_t acquire() {
    if (!free_.empty()) {
      const std::uint16_t r = free_.back();
      free_.pop_back();
      return r;
    }
    if (program_.registers == std::numeric_limits<std::uint16_t>::max())
      throw Error("the expression needs too many intermediate results");
    return static_cast<std::uint16_t>(program_.registers++);
  }

  std::vector<Operation> operations_;  // of the graph, then with fused ones
  Program program_;
  std::vector<int> last_use_;  // the last node that reads a node; -1: nobody
  std::vector<std::uint16_t> register_of_;
  std::vector<std::uint16_t> free_;
};

}  // namespace

Program compile(const Graph& graph, const std::vector<Node>& outputs) {
  return Compiler(graph).run(outputs);
}

}  // namespace isostretch::expressions
