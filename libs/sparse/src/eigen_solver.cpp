#include "eigen_solver.hpp"

#include "ordering.hpp"
#include "permuted_matrix.hpp"

#include <Eigen/SparseCholesky>

namespace isostretch::sparse {
namespace {

class EigenSolver final : public Solver {
 public:
  explicit EigenSolver(const Options& options) : options_(options) {
    statistics_.backend = Backend::eigen_ldlt;
  }

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  using View = Eigen::Map<const Matrix>;

  View view() const {
    const SymmetricMatrix& P = permuted_.matrix();
    return {P.size, P.size, P.nonzeros(), P.column_start.data(), P.row.data(), P.value.data()};
  }

  FactorResult do_analyze(const SymmetricMatrix& A) override {
    permutation_ = ordering_.compute(A, options_.ordering, last(), statistics_);
    return analyze_permuted(A);
  }

  FactorResult do_update_pattern(const SymmetricMatrix& A) override {
    permutation_ = ordering_.adapt(A);
    return analyze_permuted(A);
  }

  FactorResult analyze_permuted(const SymmetricMatrix& A) {
    permuted_ = PermutedMatrix(A, permutation_);
    factor_.analyzePattern(view());
    return {};
  }

  FactorResult do_factorize(const SymmetricMatrix& A) override {
    ++statistics_.factorizations;
    permuted_.gather(A);
    factor_.factorize(view());
    statistics_.factor_nonzeros =
        static_cast<double>(factor_.matrixL().nestedExpression().nonZeros() + A.size);
    // LDL^T goes on through negative pivots, and stops with a message of its own at a zero one.
    const auto D = factor_.vectorD();
    for (int p = 0; p < A.size; ++p)
      if (!(D[p] > 0))
        return {FactorStatus::not_positive_definite, permutation_[p],
                "not positive definite: no positive pivot in column " + std::to_string(permutation_[p])};
    if (factor_.info() != Eigen::Success) return {FactorStatus::failed, -1, "Eigen::SimplicialLDLT failed"};
    return {};
  }

  SolveResult do_solve(const double* b, double* x, int columns) override {
    const int n = permuted_.matrix().size;
    Eigen::VectorXd work(n);
    for (int c = 0; c < columns; ++c, b += n, x += n) {
      for (int p = 0; p < n; ++p) work[p] = b[permutation_[p]];
      work = factor_.solve(work).eval();
      for (int p = 0; p < n; ++p) x[permutation_[p]] = work[p];
    }
    return {};
  }

  Options options_;
  KeptOrdering ordering_;
  std::vector<int> permutation_;
  PermutedMatrix permuted_;
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factor_;
};

}  // namespace

std::unique_ptr<Solver> make_eigen_solver(const Options& options) {
  return std::make_unique<EigenSolver>(options);
}

}  // namespace isostretch::sparse
