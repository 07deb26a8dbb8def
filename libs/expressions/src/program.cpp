#include "program.hpp"

#include <isostretch/core/error.hpp>

#include <algorithm>
#include <limits>
#include <string>

namespace isostretch::expressions {
namespace {

class Compiler {
 public:
  explicit Compiler(const Graph& graph) : graph_(graph) {}

  Program run(const std::vector<Node>& outputs) {
    find_last_uses(outputs);
    // Nodes are in an order in which operands come first.
    for (Node node = 0; node < graph_.size(); ++node)
      if (last_use_[node] >= 0) emit(node);
    for (const Node output : outputs) program_.results.push_back(register_of_[output]);
    return std::move(program_);
  }

 private:
  void find_last_uses(const std::vector<Node>& outputs) {
    last_use_.assign(graph_.size(), -1);
    register_of_.assign(graph_.size(), 0);
    for (const Node output : outputs) last_use_[output] = std::numeric_limits<int>::max();
    for (Node node = static_cast<Node>(graph_.size()); node-- > 0;) {
      if (last_use_[node] < 0) continue;
      for (const Node operand : operands(node))
        last_use_[operand] = std::max(last_use_[operand], static_cast<int>(node));
    }
  }

  // Of two operands one may be a number: it needs no register then.
  Instruction::Immediate immediate(const Operation& o) const {
    if (operand_count(o.op) != 2) return Instruction::Immediate::none;
    if (graph_.is_constant(o.b)) return Instruction::Immediate::second;
    return graph_.is_constant(o.a) ? Instruction::Immediate::first : Instruction::Immediate::none;
  }

  // Those that are in registers.
  std::vector<Node> operands(Node node) const {
    const Operation& o = graph_[node];
    const Instruction::Immediate number = immediate(o);
    if (number == Instruction::Immediate::first) return {o.b};
    if (number == Instruction::Immediate::second) return {o.a};
    const Node all[] = {o.a, o.b, o.c};
    return {all, all + operand_count(o.op)};
  }

  void emit(Node node) {
    const Operation& o = graph_[node];
    const auto read = [&](int i, Node operand) {
      return i < operand_count(o.op) ? register_of_[operand] : std::uint16_t{0};
    };
    Instruction instruction{o.op, immediate(o), 0, read(0, o.a), read(1, o.b), read(2, o.c), o.value};
    if (instruction.immediate == Instruction::Immediate::first) instruction.value = graph_[o.a].value;
    if (instruction.immediate == Instruction::Immediate::second) instruction.value = graph_[o.b].value;
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

  const Graph& graph_;
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
