#include <isostretch/core/error.hpp>
#include <isostretch/sparse/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace isostretch::sparse {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw Error("symmetric matrix: " + what);
}

std::string at(int row, int column) {
  return "row " + std::to_string(row) + ", column " + std::to_string(column);
}

void validate_sizes(const SymmetricMatrix& A) {
  if (A.size < 0) fail("negative size " + std::to_string(A.size));
  if (A.column_start.size() != static_cast<std::size_t>(A.size) + 1)
    fail("column_start has " + std::to_string(A.column_start.size()) + " entries, size " +
         std::to_string(A.size) + " needs one more than that");
  if (A.column_start.front() != 0) fail("column_start[0] is " + std::to_string(A.column_start.front()));
  if (A.row.size() != A.value.size())
    fail(std::to_string(A.row.size()) + " rows but " + std::to_string(A.value.size()) + " values");
  for (int j = 0; j < A.size; ++j)
    if (A.column_start[j + 1] < A.column_start[j])
      fail("column_start decreases after column " + std::to_string(j));
  if (static_cast<std::size_t>(A.column_start.back()) != A.row.size())
    fail("column_start ends at " + std::to_string(A.column_start.back()) + " but there are " +
         std::to_string(A.row.size()) + " entries");
}

void validate_column(const SymmetricMatrix& A, int j) {
  const int begin = A.column_start[j], end = A.column_start[j + 1];
  if (begin == end || A.row[begin] != j) {
    if (begin < end && A.row[begin] < j) fail("entry above the diagonal: " + at(A.row[begin], j));
    fail("no diagonal entry in column " + std::to_string(j));
  }
  for (int k = begin + 1; k < end; ++k)
    if (A.row[k] <= A.row[k - 1]) fail("rows are not strictly increasing: " + at(A.row[k], j));
  if (A.row[end - 1] >= A.size)
    fail("outside of size " + std::to_string(A.size) + ": " + at(A.row[end - 1], j));
}

void validate_groups(const SymmetricMatrix& A) {
  if (A.group.empty()) return;
  if (A.group.size() != static_cast<std::size_t>(A.size))
    fail("group has " + std::to_string(A.group.size()) + " entries for " + std::to_string(A.size) +
         " unknowns");
  const auto drop = std::is_sorted_until(A.group.begin(), A.group.end());
  if (drop != A.group.end()) fail("group decreases at unknown " + std::to_string(drop - A.group.begin()));
}

}  // namespace

void SymmetricMatrix::validate() const {
  validate_sizes(*this);
  for (int j = 0; j < size; ++j) validate_column(*this, j);
  validate_groups(*this);
}

bool SymmetricMatrix::is_finite() const {
  // A pass without branches: 0 * value is 0 or NaN.
  double sum = 0;
  for (const double v : value) sum += 0 * v;
  return sum == 0;
}

void SymmetricMatrix::require_finite() const {
  if (is_finite()) return;
  for (int j = 0; j < size; ++j)
    for (int k = column_start[j]; k < column_start[j + 1]; ++k)
      if (!std::isfinite(value[k])) fail((std::isnan(value[k]) ? "NaN at " : "infinity at ") + at(row[k], j));
}

void SymmetricMatrix::multiply(const double* x, double* y) const {
  std::fill(y, y + size, 0.0);
  for (int j = 0; j < size; ++j) {
    const double xj = x[j];
    double sum = value[column_start[j]] * xj;
    for (int k = column_start[j] + 1; k < column_start[j + 1]; ++k) {
      sum += value[k] * x[row[k]];
      y[row[k]] += value[k] * xj;
    }
    y[j] += sum;
  }
}

}  // namespace isostretch::sparse
