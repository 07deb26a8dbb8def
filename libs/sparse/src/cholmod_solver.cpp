#include "cholmod_solver.hpp"

#include "cholmod_session.hpp"
#include "ordering.hpp"
#include "permuted_matrix.hpp"
#include "serial_openmp.hpp"

#include <algorithm>
#include <string>

namespace isostretch::sparse {
namespace {

// A pattern that has changed gets a new ordering when its factorization with the old one takes so many times
// the operations that it took when the ordering was new.
constexpr double worth_ordering = 2;

class CholmodSolver final : public Solver {
 public:
  explicit CholmodSolver(const Options& options) : options_(options) {
    cholmod_common& c = *session_.common();
    c.nmethods = 1;                    // the ordering is ours: CHOLMOD is not to try others
    c.quick_return_if_not_posdef = 1;  // a failed factorization ends at the first bad supernode
    c.final_ll = 1;                    // L L^T notices a negative pivot, L D L^T would go on
    // Merge supernodes a little more eagerly than the default {4, 16, 48}, whose supernodes of a few columns
    // suit scalar unknowns: 10 to 18 % faster on two unknowns a node, no difference on three.
    c.nrelax[0] = 8;
    c.nrelax[1] = 32;
    c.nrelax[2] = 96;
  }
  ~CholmodSolver() override { clear(); }

 private:
  FactorResult do_analyze(const SymmetricMatrix& A) override {
    permutation_ = ordering_.compute(A, options_.ordering, last(), statistics_);
    const FactorResult result = analyze_permuted(A);
    flops_when_ordered_ = statistics_.factor_flops;
    return result;
  }

  FactorResult do_update_pattern(const SymmetricMatrix& A) override {
    permutation_ = ordering_.adapt(A);
    const FactorResult result = analyze_permuted(A);
    return result && statistics_.factor_flops > worth_ordering * flops_when_ordered_ ? do_analyze(A) : result;
  }

  FactorResult analyze_permuted(const SymmetricMatrix& A) {
    clear();
    if (statistics_.ordering != Ordering::natural && !postorder(A)) return failure("symbolic analysis");
    permuted_ = PermutedMatrix(A, permutation_);
    return symbolic();
  }

  // Columns of a supernode must follow each other: permutation_ becomes its postordering (same fill).
  bool postorder(const SymmetricMatrix& A) {
    cholmod_sparse view = CholmodSession::pattern_view(A);
    cholmod_common& c = *session_.common();
    c.method[0].ordering = CHOLMOD_GIVEN;
    c.postorder = 1;
    c.supernodal = CHOLMOD_SIMPLICIAL;
    cholmod_factor* factor = cholmod_analyze_p(&view, permutation_.data(), nullptr, 0, &c);
    if (factor == nullptr) return false;
    const int* order = static_cast<const int*>(factor->Perm);
    permutation_.assign(order, order + A.size);
    cholmod_free_factor(&factor, &c);
    return true;
  }

  FactorResult symbolic() {
    cholmod_sparse view = CholmodSession::pattern_view(permuted_.matrix());
    cholmod_common& c = *session_.common();
    c.method[0].ordering = CHOLMOD_NATURAL;
    c.postorder = 0;
    c.supernodal = supernodal_mode();
    factor_ = cholmod_analyze(&view, &c);
    if (factor_ == nullptr || c.status < CHOLMOD_OK) return failure("symbolic analysis");
    statistics_.backend = factor_->is_super ? Backend::cholmod_supernodal : Backend::cholmod_simplicial;
    statistics_.factor_nonzeros = c.lnz;
    statistics_.factor_flops = c.fl;
    return {};
  }

  int supernodal_mode() const {
    return options_.backend == Backend::cholmod_simplicial ? CHOLMOD_SIMPLICIAL : CHOLMOD_SUPERNODAL;
  }

  FactorResult do_factorize(const SymmetricMatrix& A) override {
    ++statistics_.factorizations;
    permuted_.gather(A);
    cholmod_sparse view = CholmodSession::view(permuted_.matrix());
    cholmod_common& c = *session_.common();
    {
      const SerialOpenMP serial;
      cholmod_factorize(&view, factor_, &c);
    }
    if (c.status < CHOLMOD_OK) return failure("factorization");
    if (c.status == CHOLMOD_NOT_POSDEF || factor_->minor < factor_->n) return not_positive_definite();
    // Values near the ends of the floating-point range overflow on the way: the factor exists but is of no
    // use.
    if (!(cholmod_rcond(factor_, &c) > 0)) return {FactorStatus::failed, -1, "overflow in the factorization"};
    return {};
  }

  FactorResult not_positive_definite() const {
    const int column = factor_->minor < factor_->n ? permutation_[factor_->minor] : -1;
    return {FactorStatus::not_positive_definite, column,
            "not positive definite: no positive pivot in column " + std::to_string(column)};
  }

  FactorResult failure(const std::string& phase) {
    const int status = session_.common()->status;
    if (status == CHOLMOD_OUT_OF_MEMORY)
      return {FactorStatus::out_of_memory, -1, "out of memory in the " + phase};
    if (status == CHOLMOD_TOO_LARGE)
      return {FactorStatus::out_of_memory, -1, "factor too large for 32-bit indices in the " + phase};
    return {FactorStatus::failed, -1,
            "CHOLMOD failed in the " + phase + ", status " + std::to_string(status)};
  }

  SolveResult do_solve(const double* b, double* x, int columns) override {
    const int n = permuted_.matrix().size;
    work_.resize(static_cast<std::size_t>(n) * columns);
    for (int c = 0; c < columns; ++c)
      for (int p = 0; p < n; ++p) work_[offset(c) + p] = b[offset(c) + permutation_[p]];
    cholmod_dense rhs{};
    rhs.nrow = rhs.d = static_cast<std::size_t>(n);
    rhs.ncol = static_cast<std::size_t>(columns);
    rhs.nzmax = work_.size();
    rhs.x = work_.data();
    rhs.xtype = CHOLMOD_REAL;
    rhs.dtype = CHOLMOD_DOUBLE;
    if (!cholmod_solve2(CHOLMOD_A, factor_, &rhs, nullptr, &solution_, nullptr, &forward_, &backward_,
                        session_.common()))
      return {SolveStatus::failed, 0, 0, failure("solution").message};
    const double* solution = static_cast<const double*>(solution_->x);
    for (int c = 0; c < columns; ++c)
      for (int p = 0; p < n; ++p) x[offset(c) + permutation_[p]] = solution[offset(c) + p];
    return {};
  }

  std::size_t offset(int column) const {
    return static_cast<std::size_t>(column) * static_cast<std::size_t>(permuted_.matrix().size);
  }

  void clear() {
    cholmod_free_factor(&factor_, session_.common());
    for (cholmod_dense** dense : {&solution_, &forward_, &backward_})
      cholmod_free_dense(dense, session_.common());
  }

  Options options_;
  CholmodSession session_;
  KeptOrdering ordering_;
  std::vector<int> permutation_;  // position -> unknown
  double flops_when_ordered_ = 0;
  PermutedMatrix permuted_;
  std::vector<double> work_;
  cholmod_factor* factor_ = nullptr;
  // Work space that cholmod_solve2 keeps from one solution to the next.
  cholmod_dense* solution_ = nullptr;
  cholmod_dense* forward_ = nullptr;
  cholmod_dense* backward_ = nullptr;
};

}  // namespace

std::unique_ptr<Solver> make_cholmod_solver(const Options& options) {
  return std::make_unique<CholmodSolver>(options);
}

}  // namespace isostretch::sparse
