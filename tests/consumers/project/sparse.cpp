// One factorization, two right-hand sides, with whatever back ends this installation has.
#include "expect.hpp"

#include <isostretch/sparse/solver.hpp>

int main() {
  const int n = 50;
  Eigen::SparseMatrix<double> laplacian(n, n);
  for (int i = 0; i < n; ++i) {
    laplacian.insert(i, i) = 2.5;
    if (i > 0) laplacian.insert(i, i - 1) = -1.0;
  }
  const auto A = isostretch::sparse::lower_triangle(laplacian);
  for (const auto backend : isostretch::sparse::available_backends()) {
    isostretch::sparse::Options options;
    options.backend = backend;
    options.pcg_tolerance = 1e-12;
    auto solver = isostretch::sparse::make_solver(options);
    EXPECT(solver->analyze(A));
    EXPECT(solver->factorize(A));
    Eigen::MatrixXd B(n, 2), X;
    B.col(0).setOnes();
    B.col(1).setLinSpaced(-1, 1);
    EXPECT(solver->solve(B, X));
    for (int c = 0; c < 2; ++c) EXPECT((A.multiply(X.col(c)) - B.col(c)).norm() < 1e-9);
  }
}
