#include "node_system.hpp"

#include "cuthill_mckee.hpp"
#include "ordering.hpp"

#include <isostretch/core/error.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace isostretch::sparse {
namespace {

void require_axes(const SymmetricMatrix& A, const Coordinates& coordinates) {
  const auto& axis = coordinates.axis;
  if (axis.size() != static_cast<std::size_t>(A.size))
    throw Error("sparse solver: " + std::to_string(axis.size()) + " axes for " + std::to_string(A.size) +
                " unknowns");
  for (int i = 0; i < A.size; ++i) {
    const bool repeats = i > 0 && A.group[i] == A.group[i - 1] && axis[i] <= axis[i - 1];
    if (axis[i] < 0 || axis[i] >= coordinates.dim || repeats)
      throw Error("sparse solver: axis " + std::to_string(axis[i]) + " of unknown " + std::to_string(i) +
                  (repeats ? " does not follow that of its node before it" : " is outside of the dimension"));
  }
}

void require_fitting(const SymmetricMatrix& A, const Coordinates& coordinates) {
  if (coordinates.dim == 0 || A.group.empty()) return;
  const int nodes = static_cast<int>(coordinates.position.size()) / coordinates.dim;
  if (A.group.front() < 0 || A.group.back() >= nodes)
    throw Error("sparse solver: coordinates of " + std::to_string(nodes) + " nodes, but groups from " +
                std::to_string(A.group.front()) + " to " + std::to_string(A.group.back()));
  if (!coordinates.axis.empty()) require_axes(A, coordinates);
}

// Both triangles of a graph given by its lower one.
BlockCsr<double> symmetric_pattern(const SymmetricMatrix& lower) {
  BlockCsr<double> full;
  full.rows = full.columns = lower.size;
  full.start.assign(lower.size + 1, 0);
  for (int j = 0; j < lower.size; ++j)
    for (int k = lower.column_start[j]; k < lower.column_start[j + 1]; ++k) {
      ++full.start[j + 1];
      if (lower.row[k] != j) ++full.start[lower.row[k] + 1];
    }
  for (int i = 0; i < lower.size; ++i) full.start[i + 1] += full.start[i];
  full.column.resize(full.start.back());
  std::vector<int> next = full.start;
  for (int j = 0; j < lower.size; ++j)
    for (int k = lower.column_start[j]; k < lower.column_start[j + 1]; ++k) {
      full.column[next[lower.row[k]]++] = j;
      if (lower.row[k] != j) full.column[next[j]++] = lower.row[k];
    }
  return full;
}

void renumber(BlockCsr<double>& pattern, const std::vector<int>& order) {
  std::vector<int> position(order.size());
  for (std::size_t p = 0; p < order.size(); ++p) position[order[p]] = static_cast<int>(p);
  BlockCsr<double> renumbered = pattern;
  renumbered.column.clear();
  for (int p = 0; p < pattern.rows; ++p) {
    const int node = order[p];
    for (int k = pattern.start[node]; k < pattern.start[node + 1]; ++k)
      renumbered.column.push_back(position[pattern.column[k]]);
    renumbered.start[p + 1] = static_cast<int>(renumbered.column.size());
    std::sort(renumbered.column.begin() + renumbered.start[p], renumbered.column.end());
  }
  pattern = std::move(renumbered);
}

}  // namespace

void NodeSystem::analyze(const SymmetricMatrix& A, const Coordinates& coordinates) {
  require_fitting(A, coordinates);
  *this = NodeSystem();
  choose_blocks(A, coordinates);
  std::vector<int> order(matrix_.rows);
  std::iota(order.begin(), order.end(), 0);
  // Groups larger than a block stay together only in the caller's order.
  const bool split_groups = !by_groups_ && !A.group.empty();
  if (!split_groups) order = reverse_cuthill_mckee(matrix_.start, matrix_.column);
  place_unknowns(A, order, coordinates);
  renumber(matrix_, order);
  matrix_.resize_values();
  find_sources(A);
}

// Blocks as large as the largest group, unless that is more than three or would mostly be filling.
void NodeSystem::choose_blocks(const SymmetricMatrix& A, const Coordinates& coordinates) {
  GroupGraph graph = group_graph(A);
  int largest = 1;
  for (int g = 0; g < graph.matrix.size; ++g)
    largest = std::max(largest, graph.first[g + 1] - graph.first[g]);
  axes_known_ = !A.group.empty() && coordinates.dim > 0 && !coordinates.axis.empty();
  const int block = axes_known_ ? coordinates.dim : largest;
  by_groups_ = !A.group.empty() && block <= 3 && 1.0 * graph.matrix.size * block <= 1.5 * A.size + 3;
  if (!by_groups_ && !A.group.empty()) {
    axes_known_ = false;
    for (const int first : graph.first) group_start_.push_back(first);
    SymmetricMatrix single = A;
    single.group.clear();
    graph = group_graph(single);
  }
  first_ = std::move(graph.first);
  matrix_ = symmetric_pattern(graph.matrix);
  matrix_.height = matrix_.width = by_groups_ ? block : 1;
}

void NodeSystem::place_unknowns(const SymmetricMatrix& A, const std::vector<int>& order,
                                const Coordinates& coordinates) {
  const int b = matrix_.height;
  const bool complete = A.size == b * matrix_.rows;
  slot_of_.resize(A.size);
  unknown_of_.assign(static_cast<std::size_t>(b) * order.size(), -1);
  for (std::size_t p = 0; p < order.size(); ++p) {
    const int first = first_[order[p]];
    group_of_node_.push_back(A.group.empty() ? first : A.group[first]);
    for (int i = first; i < first_[order[p] + 1]; ++i) {
      slot_of_[i] = static_cast<int>(p) * b + (axes_known_ ? coordinates.axis[i] : i - first);
      unknown_of_[slot_of_[i]] = i;
    }
  }
  axes_known_ |= by_groups_ && complete;
  if (group_start_.empty())
    for (int p = 0; p <= matrix_.rows; ++p) group_start_.push_back(p * b);
  first_.clear();
}

void NodeSystem::find_sources(const SymmetricMatrix& A) {
  const int b = matrix_.height;
  source_.assign(matrix_.value.size(), -1);
  int row_node = -1, column_node = -1, lower = 0, upper = 0;
  for (int j = 0; j < A.size; ++j) {
    const int s = slot_of_[j];
    for (int k = A.column_start[j]; k < A.column_start[j + 1]; ++k) {
      const int r = slot_of_[A.row[k]];
      if (r / b != row_node || s / b != column_node) {
        row_node = r / b;
        column_node = s / b;
        lower = matrix_.find(row_node, column_node);
        upper = matrix_.find(column_node, row_node);
      }
      const auto area = static_cast<std::size_t>(b) * b;
      source_[area * lower + b * (r % b) + s % b] = k;
      source_[area * upper + b * (s % b) + r % b] = k;
    }
  }
  for (int slot = 0; slot < size(); ++slot) {
    if (unknown_of_[slot] >= 0) continue;
    const int node = slot / b, at = slot % b;
    filled_up_.push_back(static_cast<std::size_t>(matrix_.find(node, node)) * b * b + b * at + at);
  }
  diagonal_.assign(A.column_start.begin(), A.column_start.end() - 1);
}

void NodeSystem::gather(const std::vector<double>& values) {
  constexpr int least = 1 << 16;
  for_ranges(static_cast<int>(source_.size()), least, [&](int begin, int end, int) {
    for (int k = begin; k < end; ++k) matrix_.value[k] = source_[k] < 0 ? 0.0 : values[source_[k]];
  });
  double scale = 0;
  for (const int k : diagonal_) scale = std::max(scale, std::abs(values[k]));
  for (const std::size_t k : filled_up_) matrix_.value[k] = scale;
}

void NodeSystem::restore(std::vector<double>& values) const {
  for (std::size_t k = 0; k < source_.size(); ++k)
    if (source_[k] >= 0) values[source_[k]] = matrix_.value[k];
}

void NodeSystem::pad(const double* x, double* padded) const {
  for (int slot = 0; slot < size(); ++slot) padded[slot] = unknown_of_[slot] < 0 ? 0.0 : x[unknown_of_[slot]];
}

void NodeSystem::unpad(const double* padded, double* x) const {
  for (std::size_t i = 0; i < slot_of_.size(); ++i) x[i] = padded[slot_of_[i]];
}

}  // namespace isostretch::sparse
