// Eigen's decompositions as references, of matrices of run-time size: compiled once for all tests.
#pragma once

#include <Eigen/Core>

namespace isostretch::tests {

struct SymmetricEigensystem {
  Eigen::VectorXd values;  // ascending
  Eigen::MatrixXd vectors;
};

SymmetricEigensystem numerical_eigensystem(const Eigen::MatrixXd& A);

// Descending.
Eigen::VectorXd numerical_singular_values(const Eigen::MatrixXd& A);

}  // namespace isostretch::tests
