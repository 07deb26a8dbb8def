#pragma once

#include "program.hpp"

#include <isostretch/energies/chunk.hpp>

namespace isostretch::expressions {

// A program over a chunk: register r at registers + r * stride.
struct Task {
  const Instruction* code;
  std::size_t length;
  double* registers;
  const std::uint16_t* results;  // of Program::results
  double determinant_bound;      // psi is +infinity at and below it, and where it is not a number
};

struct ExpressionKernels {
  // psi, the one result.
  void (*psi[2])(const Task& task, const energies::StretchChunk& chunk);
  // From psi, P1, P2, P3, P11, P22, P33, P12, P23, P13.
  void (*from_partials[2])(const Task& task, const energies::StretchChunk& chunk);
  // From psi, its gradient, the diagonal and off-diagonal of its Hessian, and flips, by the stretches.
  void (*from_stretches[2])(const Task& task, const energies::StretchChunk& chunk);
};

}  // namespace isostretch::expressions
