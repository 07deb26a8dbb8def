#include "elimination.hpp"

#include <algorithm>
#include <cstring>

namespace isostretch::cholesky {
namespace {

// A lower triangle of zeros and the memory in which it lies.
class Triangle {
 public:
  explicit Triangle(int size) {
    const std::int64_t values = trapezoid_values(size, size) + overhang;
    if (!memory_.provide(values)) throw std::bad_alloc();
    std::memset(memory_.data(), 0, static_cast<std::size_t>(values) * sizeof(double));
    front = {memory_.data(), static_cast<std::size_t>(padded(size)), size, size};
  }

  double& operator()(int row, int column) {
    return front.values[column_place(static_cast<std::int64_t>(front.leading), column) + row];
  }

  Front front;

 private:
  Buffer memory_;
};

}  // namespace

// Rows of L of unknowns that are eliminated last have entries in columns of theirs, L_ll, and in others,
// L_lo. S = A_ll - L_lo L_lo^T = L_ll L_ll^T.
void Factor::Elimination::schur_complement(double* values) const {
  const int count = static_cast<int>(analysis_.last().size());
  std::vector<int> number(size(analysis_.size()), -1),
      position;  // of positions among the last ones, and back
  for (int s = 0; s < structure_.count(); ++s) {
    const Supernode& node = structure_.supernode[size(s)];
    for (int p = node.first; node.is_last && p < node.first + node.columns; ++p) {
      number[size(p)] = static_cast<int>(position.size());
      position.push_back(p);
    }
  }
  Triangle l(count), s(count);
  for (int k = 0; k < structure_.count(); ++k) {
    const Supernode& node = structure_.supernode[size(k)];
    if (!node.is_last) continue;
    const Front front = columns_of(k);
    for (int j = 0; j < node.columns; ++j) {
      const double* column = front.values + column_place(node.leading, j);
      for (int i = j; i < node.rows; ++i) {
        const int row = i < node.columns ? node.first + i : structure_.row[size(node.row + i - node.columns)];
        l(number[size(row)], number[size(node.first + j)]) = column[i];
      }
    }
  }
  for (int first = 0; first < count; first += block_columns)
    for (int to = first; to < count; to += block_columns)
      subtract_product(block_of(l.front, first), to - first, block_of(s.front, to), 0, count - to, first > 0);

  std::vector<int> given(size(analysis_.size()));  // of every unknown: its place in the order that was given
  for (int i = 0; i < count; ++i) given[size(analysis_.last()[size(i)])] = i;
  for (int j = 0; j < count; ++j)
    for (int i = j; i < count; ++i) {
      const std::size_t a = size(given[size(structure_.order[size(position[size(i)])])]),
                        b = size(given[size(structure_.order[size(position[size(j)])])]);
      values[a + b * size(count)] = values[b + a * size(count)] = -s(i, j);
    }
}

}  // namespace isostretch::cholesky
