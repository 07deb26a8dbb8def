#include "equality_constraints.hpp"

#include <algorithm>
#include <numeric>

namespace isostretch::newton {

EqualityConstraints::EqualityConstraints(const assembly::FreeUnknowns& free,
                                         const sparse::SymmetricMatrix& unreduced,
                                         const std::function<int(int)>& representative_dof) {
  number_unknowns(free, unreduced.group, representative_dof);
  place_entries(unreduced);
}

// In the order of the representatives, which keeps unknowns of a node together.
void EqualityConstraints::number_unknowns(const assembly::FreeUnknowns& free, const std::vector<int>& group,
                                          const std::function<int(int)>& representative_dof) {
  unknown_.assign(static_cast<std::size_t>(free.size()), -1);
  for (int i = 0; i < free.size(); ++i) {
    // A representative has the smallest number of its set, so it has been met; a set is pinned whole or not
    // at all.
    const int first = free.unknown(representative_dof(free.dof(i)));
    if (first == i) {
      unknown_[static_cast<std::size_t>(i)] = matrix_.size++;
      matrix_.group.push_back(group[static_cast<std::size_t>(i)]);
    } else {
      unknown_[static_cast<std::size_t>(i)] = unknown_[static_cast<std::size_t>(first)];
    }
  }
}

// Two counting sorts, by row and then by column, leave the rows of every column in order.
void EqualityConstraints::place_entries(const sparse::SymmetricMatrix& unreduced) {
  struct Entry {
    int column, row, from;
  };
  const std::size_t count = unreduced.row.size(), size = static_cast<std::size_t>(matrix_.size);
  std::vector<Entry> entries;
  counts_twice_.assign(count, false);
  for (int j = 0; j < unreduced.size; ++j)
    for (int k = unreduced.column_start[static_cast<std::size_t>(j)];
         k < unreduced.column_start[static_cast<std::size_t>(j) + 1]; ++k) {
      const int i = unreduced.row[static_cast<std::size_t>(k)], a = unknown(i), b = unknown(j);
      entries.push_back({std::min(a, b), std::max(a, b), k});
      counts_twice_[static_cast<std::size_t>(k)] = i != j && a == b;
    }
  const auto sort_by = [&](int Entry::*key) {
    std::vector<std::size_t> next(size + 1, 0);
    for (const Entry& entry : entries) ++next[static_cast<std::size_t>(entry.*key) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<Entry> sorted(count);
    for (const Entry& entry : entries) sorted[next[static_cast<std::size_t>(entry.*key)]++] = entry;
    entries.swap(sorted);
  };
  sort_by(&Entry::row);
  sort_by(&Entry::column);
  values_.assign(count, 0.0);
  place_.assign(count, 0);
  matrix_.column_start.assign(size + 1, 0);
  for (std::size_t e = 0; e < entries.size(); ++e) {
    const bool fresh =
        e == 0 || entries[e].column != entries[e - 1].column || entries[e].row != entries[e - 1].row;
    if (fresh) {
      matrix_.row.push_back(entries[e].row);
      ++matrix_.column_start[static_cast<std::size_t>(entries[e].column) + 1];
    }
    place_[static_cast<std::size_t>(entries[e].from)] = matrix_.nonzeros() - 1;
  }
  std::partial_sum(matrix_.column_start.begin(), matrix_.column_start.end(), matrix_.column_start.begin());
  matrix_.value.assign(matrix_.row.size(), 0.0);
}

void EqualityConstraints::reduce(std::vector<double>& values) const {
  std::fill(values.begin(), values.end(), 0.0);
  for (std::size_t k = 0; k < values_.size(); ++k)
    values[static_cast<std::size_t>(place_[k])] += (counts_twice_[k] ? 2.0 : 1.0) * values_[k];
}

}  // namespace isostretch::newton
