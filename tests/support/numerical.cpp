#include "numerical.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace isostretch::tests {

SymmetricEigensystem numerical_eigensystem(const Eigen::MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(A);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

Eigen::VectorXd numerical_singular_values(const Eigen::MatrixXd& A) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(A).singularValues();
}

}  // namespace isostretch::tests
