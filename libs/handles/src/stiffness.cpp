#include "stiffness.hpp"

#include <isostretch/assembly/operators.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::handles {
namespace {

double diagonal_of(const Rows& rows, int n) {
  const auto& row = rows[static_cast<std::size_t>(n)];
  const auto found =
      std::find_if(row.begin(), row.end(), [&](const Entry& entry) { return entry.column == n; });
  return found == row.end() ? 0 : found->value;
}

// Edges opposite to right angles alone have no stiffness but rounding. There are many in meshes of boxes,
// and K M^-1 K would join the neighbours of both ends.
void drop_rounding(Rows& K) {
  std::vector<double> scale(K.size());
  for (std::size_t n = 0; n < K.size(); ++n) scale[n] = std::sqrt(diagonal_of(K, static_cast<int>(n)));
  for (std::size_t n = 0; n < K.size(); ++n)
    std::erase_if(K[n], [&](const Entry& entry) {
      return std::abs(entry.value) <= 1e-15 * scale[n] * scale[static_cast<std::size_t>(entry.column)];
    });
}

}  // namespace

Rows stiffness_rows(const assembly::Elements& elements) {
  const sparse::SymmetricMatrix K = assembly::operators::laplacian(elements);
  Rows rows(static_cast<std::size_t>(K.size));
  for (int j = 0; j < K.size; ++j)
    for (auto k = static_cast<std::size_t>(K.column_start[static_cast<std::size_t>(j)]);
         k < static_cast<std::size_t>(K.column_start[static_cast<std::size_t>(j) + 1]); ++k) {
      const int i = K.row[k];  // of the lower triangle: column j of later rows, and row j itself
      rows[static_cast<std::size_t>(i)].push_back({j, K.value[k]});
      if (i != j) rows[static_cast<std::size_t>(j)].push_back({i, K.value[k]});
    }
  drop_rounding(rows);
  return rows;
}

Rows squared(const Rows& K, const std::vector<double>& mass) {
  Rows result(K.size());
  std::vector<double> sums(K.size(), 0.0);
  std::vector<bool> touched(K.size(), false);
  for (std::size_t i = 0; i < K.size(); ++i) {
    std::vector<int> columns;
    for (const Entry& first : K[i])
      for (const Entry& second : K[static_cast<std::size_t>(first.column)]) {
        const auto j = static_cast<std::size_t>(second.column);
        if (!touched[j]) columns.push_back(second.column);
        touched[j] = true;
        sums[j] += first.value * second.value / mass[static_cast<std::size_t>(first.column)];
      }
    std::sort(columns.begin(), columns.end());
    for (const int j : columns) {
      result[i].push_back({j, sums[static_cast<std::size_t>(j)]});
      sums[static_cast<std::size_t>(j)] = 0;
      touched[static_cast<std::size_t>(j)] = false;
    }
  }
  return result;
}

}  // namespace isostretch::handles
