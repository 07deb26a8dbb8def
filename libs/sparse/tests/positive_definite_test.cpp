// Which matrices a factorization takes for positive definite.
#include "every_solver.hpp"
#include "matrices.hpp"

#include <isostretch/sparse/solver.hpp>

#include <doctest/doctest.h>

#include <Eigen/IterativeLinearSolvers>

using namespace isostretch::sparse;
using namespace isostretch::sparse::test;

namespace {

// An entry on the diagonal of the inverse, by Eigen's conjugate gradients.
double diagonal_of_inverse(const SymmetricMatrix& A, int place) {
  const Eigen::SparseMatrix<double> lower = Eigen::Map<const Eigen::SparseMatrix<double>>(
      A.size, A.size, A.nonzeros(), A.column_start.data(), A.row.data(), A.value.data());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower> solver(lower);
  solver.setTolerance(1e-12);
  const Eigen::VectorXd column = solver.solve(Eigen::VectorXd::Unit(A.size, place));
  REQUIRE(solver.info() == Eigen::Success);
  return column[place];
}

}  // namespace

TEST_CASE("sparse solver: the verdict of definiteness depends neither on size nor on place") {
  int checked = 0;
  for_each_solver([&](const Options& options) {
    if (options.backend == Backend::pcg) return;  // it looks along its search directions alone
    for (const int size : {1, 2, 3, 5, 8, 17, 40, 100, 400, 1500})
      for (const double shift : {1e-3, -1e-3}) {
        // Positive definite but for one eigenvalue of the sign of the shift, which no diagonal entry shows.
        SymmetricMatrix A = random_spd(size, 3, static_cast<unsigned>(size));
        const int place = size / 3;
        if (size == 1) {
          A.value[0] = shift;
        } else {
          // A - (1 - shift) e e^T / (e^T A^-1 e) is singular at shift = 0.
          diagonal_entry(A, place) -= (1 - shift) / diagonal_of_inverse(A, place);
        }
        CAPTURE(size);
        CAPTURE(shift);
        const auto solver = make_solver(options);
        REQUIRE(solver->analyze(A));
        const FactorResult result = solver->factorize(A);
        CHECK(static_cast<bool>(result) == (shift > 0));
        if (shift < 0) CHECK(result.status == FactorStatus::not_positive_definite);
        ++checked;
      }
  });
  CHECK(checked >= 20);
}
