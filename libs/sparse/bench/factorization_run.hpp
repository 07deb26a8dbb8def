#pragma once

#include <isostretch/sparse/solver.hpp>

#include <string>

namespace isostretch::sparse::bench {

// What is measured, and how often: up to so many repetitions of each phase after the first, fewer where they
// take longer than so many seconds together, one at least.
struct Run {
  Options options;
  int threads = 1;
  int repetitions = 9;
  double seconds = 10;
  int last = 0;  // unknowns that are eliminated last, and factorised again without the others
};

// Measures one solver with one matrix. Returns a line of JSON: seconds are medians of the repetitions after
// the first, and of the first where they are called so.
std::string measure(const SymmetricMatrix& A, const std::string& matrix, const Run& run);

}  // namespace isostretch::sparse::bench
