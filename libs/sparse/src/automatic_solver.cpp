#include "automatic_solver.hpp"

#include "direct_solver.hpp"
#include "ordering.hpp"
#include "pcg_solver.hpp"

#include <isostretch/core/log.hpp>

#include <unistd.h>

#include <limits>
#include <utility>
#include <vector>

namespace isostretch::sparse {
namespace {

// Larger matrices of the 3D kind are not even analyzed for a factorization: none was faster (README.md), and
// nested dissection alone takes seconds.
constexpr int largest_to_analyze = 300000;

// Of the memory there is, a factor and the work space for it may take this share.
constexpr double share_of_memory = 0.6;

// Multiplications of a solve by pcg, after which a factorization would have been no slower.
constexpr int patience = 500;

double physical_memory() {
  return static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGE_SIZE));
}

// A solver of its own kind behind this one, chosen at every analyze().
class AutomaticSolver final : public Solver {
 public:
  explicit AutomaticSolver(const Options& options) : options_(options) {}

 private:
  FactorResult do_analyze(const SymmetricMatrix& A) override {
    may_give_up_ = true;
    if (A.size > largest_to_analyze && is_spatial(A)) return iterative(A);
    return direct(A, options_.automatic_max_flops);
  }

  // A factorization unless it does not fit into memory or takes more operations than this.
  FactorResult direct(const SymmetricMatrix& A, double most_flops) {
    use(make_direct_solver(options_));
    most_flops_ = most_flops;
    return judged(chosen_->analyze(A), A);
  }

  FactorResult judged(const FactorResult& analysis, const SymmetricMatrix& A) {
    const Statistics& factor = chosen_->statistics();
    const bool too_large = analysis.status == FactorStatus::out_of_memory ||
                           factor.factor_bytes > share_of_memory * physical_memory();
    if (too_large || (factor.factor_flops > most_flops_ && is_spatial(A))) return iterative(A);
    take_statistics();
    return analysis;
  }

  // The choice stays, unless the factor outgrows what may be factorised.
  FactorResult do_update_pattern(const SymmetricMatrix& A) override {
    const bool factorises = chosen_->statistics().backend != Backend::pcg;
    const FactorResult result = chosen_->update_pattern(A);
    if (factorises) return judged(result, A);
    take_statistics();
    return result;
  }

  bool is_spatial(const SymmetricMatrix& A) const { return dim_ == 0 ? is_of_3d_kind(A) : dim_ == 3; }

  FactorResult iterative(const SymmetricMatrix& A) {
    Options options = options_;
    options.backend = Backend::pcg;
    options.pcg_preconditioner = Preconditioner::amg;
    if (options.pcg_max_iterations == 0) options.pcg_max_iterations = patience;
    use(make_pcg_solver(options));
    const FactorResult result = chosen_->analyze(A);
    take_statistics();
    return result;
  }

  void use(std::unique_ptr<Solver> solver) {
    chosen_ = std::move(solver);
    counted_ = {};
    chosen_->set_last(last());
    if (tolerance_ > 0) chosen_->set_tolerance(tolerance_);
    if (dim_ > 0) chosen_->set_coordinates(positions_.data(), dim_, nodes(), axis_);
  }

  FactorResult do_factorize(const SymmetricMatrix& A) override {
    if (chosen_->statistics().backend == Backend::pcg && may_give_up_) matrix_ = A;
    const FactorResult result = chosen_->factorize(A);
    take_statistics();
    return result;
  }

  FactorResult do_refactorize(const SymmetricMatrix& A) override {
    if (chosen_->statistics().backend == Backend::pcg) return do_factorize(A);
    const FactorResult result = chosen_->refactorize(A);
    take_statistics();
    return result;
  }

  bool do_schur_complement(double* values) const override {
    if (chosen_->statistics().backend != Backend::multifrontal) return false;
    chosen_->schur_complement(values);
    return true;
  }

  SolveResult do_solve(const double* b, double* x, int columns) override {
    const SolveResult result = chosen_->solve_columns(b, x, columns);
    take_statistics();
    if (result.status == SolveStatus::not_converged && may_give_up_ && factorize_instead())
      return do_solve(b, x, columns);
    return result;
  }

  void do_set_tolerance(double tolerance) override {
    tolerance_ = tolerance;
    if (chosen_) chosen_->set_tolerance(tolerance);
  }

  void do_set_coordinates(const double* positions, int dim, int nodes,
                          const std::vector<int>& axis) override {
    positions_.assign(positions, positions + static_cast<std::size_t>(dim) * nodes);
    axis_ = axis;
    dim_ = dim;
    if (chosen_) chosen_->set_coordinates(positions, dim, nodes, axis);
  }

  // Where pcg has not converged: whether there is a factor now instead, for this matrix and those that
  // follow. Tried once a pattern.
  bool factorize_instead() {
    may_give_up_ = false;
    log(LogLevel::info,
        "sparse: conjugate gradients have not converged; a factorization is tried in their place");
    const SymmetricMatrix A = std::move(matrix_);
    matrix_ = {};
    if (!direct(A, std::numeric_limits<double>::infinity())) return false;
    const FactorResult result = chosen_->factorize(A);
    take_statistics();
    return result && statistics_.backend != Backend::pcg;
  }

  int nodes() const { return static_cast<int>(positions_.size()) / dim_; }

  // Seconds and calls are counted by this solver itself; the rest is the chosen one's, sums since it was
  // chosen.
  void take_statistics() {
    const Statistics& from = chosen_->statistics();
    statistics_.backend = from.backend;
    statistics_.preconditioner = from.preconditioner;
    statistics_.ordering = from.ordering;
    statistics_.factor_nonzeros = from.factor_nonzeros;
    statistics_.factor_flops = from.factor_flops;
    statistics_.factor_bytes = from.factor_bytes;
    statistics_.orderings += from.orderings - counted_.orderings;
    statistics_.ordering_seconds += from.ordering_seconds - counted_.ordering_seconds;
    statistics_.factorizations += from.factorizations - counted_.factorizations;
    statistics_.multiplications += from.multiplications - counted_.multiplications;
    counted_ = from;
  }

  Options options_;
  SymmetricMatrix matrix_;    // of pcg, as long as it may be given up
  bool may_give_up_ = false;  // pcg has not failed yet on this pattern
  std::unique_ptr<Solver> chosen_;
  Statistics counted_;     // of chosen_, so far
  double most_flops_ = 0;  // of a factorization
  double tolerance_ = 0;
  std::vector<double> positions_;
  std::vector<int> axis_;
  int dim_ = 0;
};

}  // namespace

std::unique_ptr<Solver> make_automatic_solver(const Options& options) {
  return std::make_unique<AutomaticSolver>(options);
}

}  // namespace isostretch::sparse
