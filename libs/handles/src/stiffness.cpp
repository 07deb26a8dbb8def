#include "stiffness.hpp"

#include <algorithm>
#include <cmath>

namespace isostretch::handles {
namespace {

double dot(const double* a, const double* b, int dim) {
  double sum = 0;
  for (int i = 0; i < dim; ++i) sum += a[i] * b[i];
  return sum;
}

// Entries of the same column summed, in the order in which they came.
void merge(std::vector<Entry>& row) {
  std::stable_sort(row.begin(), row.end(),
                   [](const Entry& a, const Entry& b) { return a.column < b.column; });
  std::size_t last = 0;
  for (std::size_t i = 1; i < row.size(); ++i) {
    if (row[i].column == row[last].column)
      row[last].value += row[i].value;
    else
      row[++last] = row[i];
  }
  if (!row.empty()) row.resize(last + 1);
}

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
  const int k = elements.nodes_per_element, points = elements.points_per_element, dim = elements.dim;
  Rows rows(static_cast<std::size_t>(elements.node_count));
  for (int e = 0; e < elements.element_count(); ++e)
    for (int a = 0; a < k; ++a)
      for (int b = 0; b < k; ++b) {
        double sum = 0;
        for (int p = 0; p < points; ++p) {
          const std::size_t point =
              static_cast<std::size_t>(e) * static_cast<std::size_t>(points) + static_cast<std::size_t>(p);
          const double* g = elements.gradients.data() + point * static_cast<std::size_t>(k * dim);
          sum += elements.weights[point] * dot(g + a * dim, g + b * dim, dim);
        }
        const int* nodes = elements.nodes.data() + static_cast<std::ptrdiff_t>(e) * k;
        rows[static_cast<std::size_t>(nodes[a])].push_back({nodes[b], sum});
      }
  for (auto& row : rows) merge(row);
  drop_rounding(rows);
  return rows;
}

std::vector<double> lumped_mass(const assembly::Elements& elements) {
  std::vector<double> mass(static_cast<std::size_t>(elements.node_count), 0.0);
  const auto k = static_cast<std::size_t>(elements.nodes_per_element),
             points = static_cast<std::size_t>(elements.points_per_element);
  for (std::size_t i = 0; i < elements.nodes.size(); ++i)
    for (std::size_t p = 0; p < points; ++p)
      mass[static_cast<std::size_t>(elements.nodes[i])] +=
          elements.weights[i / k * points + p] / static_cast<double>(k);
  return mass;
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
