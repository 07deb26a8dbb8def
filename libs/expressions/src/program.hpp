#pragma once

#include "graph.hpp"

#include <cstdint>
#include <vector>

namespace isostretch::expressions {

// Operations in an order in which they can be carried out, on numbered registers, each one array of a chunk.
struct Instruction {
  enum class Immediate : std::uint8_t { none, first, second, third };

  Op op;
  Immediate immediate = Immediate::none;  // the operand that is `value`, in the place of a register
  std::uint16_t to, a, b, c;
  double value;
};

struct Program {
  std::vector<Instruction> code;
  std::vector<std::uint16_t> results;  // registers of the outputs, in the order asked for
  int registers = 0;
};

// What the outputs need and nothing else; the first is psi. A register is used again when nobody reads it any
// more, and a product that only a sum reads becomes one operation with it.
Program compile(const Graph& graph, const std::vector<Node>& outputs);

}  // namespace isostretch::expressions
