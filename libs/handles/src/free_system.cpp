#include "free_system.hpp"

#include "constant_parts.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/index.hpp>
#include <isostretch/sparse/solver.hpp>

#include <algorithm>

namespace isostretch::handles {
namespace {

void require(const std::string& message) {
  if (!message.empty()) throw Error("weights: the system of the free nodes: " + message);
}

}  // namespace

// In space the rows of A have 60 entries, and finding an order for so dense a graph takes as long as the
// factorization. Groups of neighbours, whose graph is ordered in their place, take an eighth of that.
FreeSystem::FreeSystem(const Rows& stiffness, const Rows& squared, int dim, const sparse::Options& solver)
    : squared_(squared), dim_(dim), solver_(solver), group_(stiffness.size(), -1) {
  const int largest = dim == 3 ? 8 : 1;
  // By its density the solver would take the plane for space, and nested dissection, ten times as slow.
  if (dim == 2 && solver_.ordering == sparse::Ordering::automatic) solver_.ordering = sparse::Ordering::amd;
  int groups = 0;
  for (std::size_t n = 0; n < stiffness.size(); ++n) {
    if (group_[n] >= 0) continue;
    const auto join = [&](int node) {
      group_[at(node)] = groups;
      order_.push_back(node);
    };
    const std::size_t first = order_.size();
    join(static_cast<int>(n));
    for (const Entry& entry : stiffness[n])
      if (group_[at(entry.column)] < 0 && order_.size() < first + at(largest)) join(entry.column);
    ++groups;
  }
}

void FreeSystem::solve(const std::vector<bool>& free, std::vector<double>& w, int columns) const {
  const std::vector<bool> to_solve = solve_constant_parts(squared_, free, w, columns);
  std::vector<int> unknown(free.size(), -1), node;
  sparse::SymmetricMatrix A;
  for (const int n : order_) {
    if (!to_solve[at(n)]) continue;
    unknown[at(n)] = static_cast<int>(node.size());
    node.push_back(n);
    A.group.push_back(group_[at(n)]);
  }
  if (node.empty()) return;
  A.size = static_cast<int>(node.size());
  A.column_start.push_back(0);
  std::vector<Entry> column;
  for (int j = 0; j < A.size; ++j) {
    column.clear();
    for (const Entry& entry : squared_[at(node[at(j)])])
      if (unknown[at(entry.column)] >= j) column.push_back({unknown[at(entry.column)], entry.value});
    std::sort(column.begin(), column.end(),
              [](const Entry& a, const Entry& b) { return a.column < b.column; });
    for (const Entry& entry : column) {
      A.row.push_back(entry.column);
      A.value.push_back(entry.value);
    }
    A.column_start.push_back(A.nonzeros());
  }
  const auto solver = sparse::make_solver(solver_);
  // As in extension.cpp: the solver is to know the dimension, places do not matter.
  const std::vector<double> anywhere(free.size() * at(dim_), 0.0);
  solver->set_coordinates(anywhere.data(), dim_, static_cast<int>(free.size()));
  require(solver->analyze(A).message);
  require(solver->factorize(A).message);
  const std::size_t count = node.size(), nodes = free.size();
  std::vector<double> right(count * at(columns)), solution(right.size());
  for (std::size_t c = 0; c < at(columns); ++c)
    for (std::size_t i = 0; i < count; ++i) {
      double sum = 0;
      for (const Entry& entry : squared_[at(node[i])])
        if (!to_solve[at(entry.column)]) sum -= entry.value * w[c * nodes + at(entry.column)];
      right[c * count + i] = sum;
    }
  require(solver->solve_columns(right.data(), solution.data(), columns).message);
  for (std::size_t c = 0; c < at(columns); ++c)
    for (std::size_t i = 0; i < count; ++i) w[c * nodes + at(node[i])] = solution[c * count + i];
}

}  // namespace isostretch::handles
