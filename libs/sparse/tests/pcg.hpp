#pragma once

// Conjugate gradients as tests ask for them, and solving with a look at what comes out.
#include "matrices.hpp"

#include <isostretch/sparse/solver.hpp>

#include <doctest/doctest.h>

namespace isostretch::sparse::test {

inline Options pcg(Preconditioner preconditioner, double tolerance = 1e-9) {
  Options options;
  options.backend = Backend::pcg;
  options.pcg_preconditioner = preconditioner;
  options.pcg_tolerance = tolerance;
  return options;
}

struct Solved {
  Eigen::VectorXd x;
  SolveResult result;
};

inline Solved solve(Solver& solver, const SymmetricMatrix& A, const Eigen::VectorXd& b) {
  const FactorResult factored = solver.factorize(A);
  REQUIRE_MESSAGE(factored, factored.message);
  Solved solved;
  solved.result = solver.solve(b, solved.x);
  return solved;
}

inline void check_solves(Solver& solver, const SymmetricMatrix& A, double tolerance = 1e-9) {
  const Eigen::VectorXd b = random_vector(A.size, 5);
  const Solved solved = solve(solver, A, b);
  CHECK_MESSAGE(solved.result, solved.result.message);
  CHECK(relative_residual(A, solved.x, b) <= 1.0001 * tolerance);
}

}  // namespace isostretch::sparse::test
