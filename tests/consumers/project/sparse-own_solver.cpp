// A linear solver of one's own, under a name that goes wherever those of the back ends do.
#include "expect.hpp"

#include <isostretch/sparse/solver.hpp>

#include <Eigen/Cholesky>

#include <algorithm>
#include <memory>

using namespace isostretch;

class DenseCholesky final : public sparse::Solver {
 private:
  sparse::FactorResult do_analyze(const sparse::SymmetricMatrix&) override { return {}; }
  sparse::FactorResult do_factorize(const sparse::SymmetricMatrix& A) override {
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(A.size, A.size);
    for (int j = 0; j < A.size; ++j)
      for (int k = A.column_start[j]; k < A.column_start[j + 1]; ++k) dense(A.row[k], j) = A.value[k];
    factor_.compute(dense);
    if (factor_.info() == Eigen::Success) return {};
    return {sparse::FactorStatus::not_positive_definite, -1, "not positive definite"};
  }
  sparse::SolveResult do_solve(const double* b, double* x, int columns) override {
    const auto size = factor_.rows();
    Eigen::Map<Eigen::MatrixXd>(x, size, columns) =
        factor_.solve(Eigen::Map<const Eigen::MatrixXd>(b, size, columns));
    return {};
  }

  Eigen::LLT<Eigen::MatrixXd> factor_;
};

int main() {
  sparse::register_solver("dense_cholesky",
                          [](const sparse::Options&) { return std::make_unique<DenseCholesky>(); });
  sparse::Options options;
  options.backend = sparse::backend_from_name("dense_cholesky");
  const auto backends = sparse::available_backends();
  EXPECT(std::find(backends.begin(), backends.end(), options.backend) != backends.end());

  const int n = 40;
  Eigen::SparseMatrix<double> laplacian(n, n);
  for (int i = 0; i < n; ++i) {
    laplacian.insert(i, i) = 2.5;
    if (i > 0) laplacian.insert(i, i - 1) = -1.0;
  }
  auto A = sparse::lower_triangle(laplacian);
  const auto solver = sparse::make_solver(options);
  EXPECT(solver->analyze(A));
  EXPECT(solver->factorize(A));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 2);
  Eigen::VectorXd x;
  EXPECT(solver->solve(b, x));
  EXPECT((A.multiply(x) - b).norm() < 1e-12);
  A.value[0] = -1;
  EXPECT(solver->factorize(A).status == sparse::FactorStatus::not_positive_definite);
}
