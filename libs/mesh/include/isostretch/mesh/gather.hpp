#pragma once

#include <Eigen/Core>

#include <vector>

namespace isostretch::mesh {

/// Returns the listed rows of a matrix, in the order of the list.
template <class Matrix>
Matrix gather(const Matrix& matrix, const std::vector<int>& rows) {
  Matrix gathered(static_cast<Eigen::Index>(rows.size()), matrix.cols());
  for (std::size_t i = 0; i < rows.size(); ++i)
    gathered.row(static_cast<Eigen::Index>(i)) = matrix.row(rows[i]);
  return gathered;
}

}  // namespace isostretch::mesh
