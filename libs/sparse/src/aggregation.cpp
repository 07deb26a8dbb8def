#include "aggregation.hpp"

#include <algorithm>

namespace isostretch::sparse {
namespace {

constexpr int least_rows = 2048;

double squared_norm(const double* block, std::size_t area) {
  double sum = 0;
  for (std::size_t e = 0; e < area; ++e) sum += block[e] * block[e];
  return sum;
}

class Aggregation {
 public:
  Aggregation(const BlockCsr<double>& A, const std::vector<char>& strong) : A_(A), strong_(strong) {
    all_.of.assign(A.rows, unassigned);
  }

  Aggregates compute() {
    leave_out_isolated();
    whole_neighbourhoods();
    join_neighbours();
    for (int i = 0; i < A_.rows; ++i)
      if (all_.of[i] == unassigned) begin_aggregate(i);
    return std::move(all_);
  }

 private:
  static constexpr int isolated = -1, unassigned = -2;

  template <class Visit>
  void for_neighbours(int i, const Visit& visit) const {
    for (int k = A_.start[i]; k < A_.start[i + 1]; ++k)
      if (strong_[k] != 0 && A_.column[k] != i) visit(A_.column[k], k);
  }

  void leave_out_isolated() {
    for (int i = 0; i < A_.rows; ++i) {
      int neighbours = 0;
      for_neighbours(i, [&](int, int) { ++neighbours; });
      if (neighbours == 0) all_.of[i] = isolated;
    }
  }

  void begin_aggregate(int i) {
    all_.of[i] = all_.count;
    for_neighbours(i, [&](int j, int) {
      if (all_.of[j] == unassigned) all_.of[j] = all_.count;
    });
    ++all_.count;
  }

  void whole_neighbourhoods() {
    for (int i = 0; i < A_.rows; ++i) {
      bool whole = all_.of[i] == unassigned;
      for_neighbours(i, [&](int j, int) { whole = whole && all_.of[j] == unassigned; });
      if (whole) begin_aggregate(i);
    }
  }

  // Each to the aggregate of the first pass that it couples with most.
  void join_neighbours() {
    const std::vector<int> before = all_.of;
    for (int i = 0; i < A_.rows; ++i) {
      if (before[i] != unassigned) continue;
      double strongest = 0;
      for_neighbours(i, [&](int j, int k) {
        const double norm = squared_norm(A_.block(k), A_.area());
        if (before[j] < 0 || norm <= strongest) return;
        strongest = norm;
        all_.of[i] = before[j];
      });
    }
  }

  const BlockCsr<double>& A_;
  const std::vector<char>& strong_;
  Aggregates all_;
};

}  // namespace

std::vector<char> strong_couplings(const BlockCsr<double>& A, double threshold) {
  std::vector<double> diagonal(A.rows);
  for_ranges(A.rows, least_rows, [&](int begin, int end, int) {
    for (int i = begin; i < end; ++i) diagonal[i] = squared_norm(A.block(A.find(i, i)), A.area());
  });
  const double factor = threshold * threshold * threshold * threshold;
  std::vector<char> strong(A.column.size());
  for_ranges(A.rows, least_rows, [&](int begin, int end, int) {
    for (int i = begin; i < end; ++i)
      for (int k = A.start[i]; k < A.start[i + 1]; ++k) {
        const double norm = squared_norm(A.block(k), A.area());
        strong[k] = A.column[k] == i || norm * norm > factor * diagonal[i] * diagonal[A.column[k]] ? 1 : 0;
      }
  });
  return strong;
}

BlockCsr<double> lump_weak(const BlockCsr<double>& A, const std::vector<char>& strong) {
  BlockCsr<double> F;
  F.rows = A.rows;
  F.columns = A.columns;
  F.height = A.height;
  F.width = A.width;
  F.start.assign(A.rows + 1, 0);
  for (int i = 0; i < A.rows; ++i) {
    for (int k = A.start[i]; k < A.start[i + 1]; ++k)
      if (strong[k] != 0) F.column.push_back(A.column[k]);
    F.start[i + 1] = static_cast<int>(F.column.size());
  }
  F.resize_values();
  for_ranges(A.rows, least_rows, [&](int begin, int end, int) {
    for (int i = begin; i < end; ++i) {
      double* diagonal = F.block(F.find(i, i));
      int next = F.start[i];
      for (int k = A.start[i]; k < A.start[i + 1]; ++k) {
        double* to = strong[k] != 0 ? F.block(next++) : diagonal;
        for (std::size_t e = 0; e < A.area(); ++e) to[e] += A.block(k)[e];
      }
    }
  });
  return F;
}

Aggregates aggregate(const BlockCsr<double>& A, const std::vector<char>& strong) {
  return Aggregation(A, strong).compute();
}

}  // namespace isostretch::sparse
