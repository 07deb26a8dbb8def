#pragma once

namespace isostretch::sparse::bench {

// The arithmetic that a core can do at best, one table for every instruction-set level.
struct PeakTable {
  double operations;  // of a round, a multiplication and an addition counted as two

  // Does so many rounds of independent multiplications and additions in registers. What it returns means
  // nothing.
  double (*multiply_add)(long rounds);
};

}  // namespace isostretch::sparse::bench
