#include "multifrontal_solver.hpp"

#include "ordering.hpp"

#include <isostretch/cholesky/factor.hpp>
#include <isostretch/core/error.hpp>

#include <memory>
#include <new>
#include <string>
#include <vector>

namespace isostretch::sparse {
namespace {

// A pattern that has changed gets a new ordering when its factorization with the old one takes so many times
// the operations that it took when the ordering was new.
constexpr double worth_ordering = 2;

class MultifrontalSolver final : public Solver {
 public:
  explicit MultifrontalSolver(const Options& options) : options_(options) {}

 private:
  FactorResult do_analyze(const SymmetricMatrix& A) override {
    const FactorResult result =
        analyze_in_order(A, ordering_.compute(A, options_.ordering, last(), statistics_));
    flops_when_ordered_ = statistics_.factor_flops;
    return result;
  }

  FactorResult do_update_pattern(const SymmetricMatrix& A) override {
    const FactorResult result = analyze_in_order(A, ordering_.adapt(A));
    return result && statistics_.factor_flops > worth_ordering * flops_when_ordered_ ? do_analyze(A) : result;
  }

  FactorResult analyze_in_order(const SymmetricMatrix& A, const std::vector<int>& order) {
    factor_.reset();
    statistics_.backend = Backend::multifrontal;
    try {
      analysis_ = cholesky::Analysis({A.size, A.column_start.data(), A.row.data()}, order, {},
                                     ordering_.last_count());
    } catch (const std::bad_alloc&) {
      return {FactorStatus::out_of_memory, -1, "out of memory in the symbolic analysis"};
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::resource) throw;
      return {FactorStatus::out_of_memory, -1, error.what()};
    }
    factor_ = std::make_unique<cholesky::Factor>(analysis_);
    statistics_.factor_nonzeros = analysis_.factor_nonzeros();
    statistics_.factor_flops = analysis_.factor_flops();
    statistics_.factor_bytes = static_cast<double>(factor_->bytes());
    return {};
  }

  FactorResult do_factorize(const SymmetricMatrix& A) override {
    return counted(factor_->factorize(A.value.data()));
  }

  FactorResult do_refactorize(const SymmetricMatrix& A) override {
    return counted(factor_->refactorize(A.value.data()));
  }

  bool do_schur_complement(double* values) const override {
    factor_->schur_complement(values);
    return true;
  }

  FactorResult counted(const cholesky::FactorizeResult& result) {
    ++statistics_.factorizations;
    switch (result.status) {
      case cholesky::FactorizeStatus::not_positive_definite:
        return {FactorStatus::not_positive_definite, result.unknown,
                "not positive definite: no positive pivot in column " + std::to_string(result.unknown)};
      case cholesky::FactorizeStatus::not_finite:
        return {FactorStatus::failed, result.unknown, "overflow in the factorization"};
      case cholesky::FactorizeStatus::out_of_memory:
        return {FactorStatus::out_of_memory, -1, "out of memory in the factorization"};
      case cholesky::FactorizeStatus::ok:
        break;
    }
    return {};
  }

  SolveResult do_solve(const double* b, double* x, int columns) override {
    factor_->solve(b, x, columns);
    return {};
  }

  Options options_;
  KeptOrdering ordering_;
  double flops_when_ordered_ = 0;
  cholesky::Analysis analysis_;
  std::unique_ptr<cholesky::Factor> factor_;
};

}  // namespace

std::unique_ptr<Solver> make_multifrontal_solver(const Options& options) {
  return std::make_unique<MultifrontalSolver>(options);
}

}  // namespace isostretch::sparse
