#include "mumps_solver.hpp"

#include "../src/ordering.hpp"

#include <isostretch/sparse/solver.hpp>

#include <dmumps_c.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace isostretch::sparse::bench {
namespace {

// Jobs, and numbers of errors, of MUMPS' users' guide.
enum Job { start = -1, end = -2, analysis = 1, factorization = 2, solution = 3 };
constexpr int numerically_singular = -10, no_memory = -13, not_positive = -40;

class MumpsSolver final : public Solver {
 public:
  explicit MumpsSolver(const Options& options) : options_(options) {
    statistics_.backend = options.backend;
    constexpr int world = -987654, positive_definite = 1;
    mumps_.comm_fortran = world;
    mumps_.par = 1;
    mumps_.sym = positive_definite;
    run(start);
    for (const int stream : {1, 2, 3, 4}) control(stream) = 0;  // prints nothing
    control(7) = 1;                                             // the order is given
    control(8) = 0;                                             // no scaling: nobody else scales
    control(28) = 1;                                            // the analysis of one process
  }
  ~MumpsSolver() override { run(end); }

 private:
  MUMPS_INT& control(int number) { return mumps_.icntl[number - 1]; }
  MUMPS_INT info(int number) const { return mumps_.infog[number - 1]; }

  void run(Job job) {
    mumps_.job = job;
    dmumps_c(&mumps_);
  }

  FactorResult do_analyze(const SymmetricMatrix& A) override {
    const std::vector<int> order = ordering_.compute(A, options_.ordering, last(), statistics_);
    position_.resize(order.size());
    for (int p = 0; p < A.size; ++p) position_[static_cast<std::size_t>(order[p])] = p + 1;
    set_pattern(A);
    run(analysis);
    statistics_.factor_flops = mumps_.rinfog[0];
    statistics_.factor_nonzeros = info(20) < 0 ? -1e6 * info(20) : info(20);
    statistics_.factor_bytes = 1e6 * info(17);
    return result();
  }

  void set_pattern(const SymmetricMatrix& A) {
    row_.clear();
    column_.clear();
    for (int j = 0; j < A.size; ++j)
      for (int k = A.column_start[j]; k < A.column_start[j + 1]; ++k) {
        row_.push_back(A.row[k] + 1);
        column_.push_back(j + 1);
      }
    mumps_.n = A.size;
    mumps_.nnz = A.nonzeros();
    mumps_.irn = row_.data();
    mumps_.jcn = column_.data();
    mumps_.perm_in = position_.data();
  }

  FactorResult do_factorize(const SymmetricMatrix& A) override {
    ++statistics_.factorizations;
    mumps_.a = const_cast<double*>(A.value.data());  // only read
    run(factorization);
    return result();
  }

  SolveResult do_solve(const double* b, double* x, int columns) override {
    const std::size_t values = static_cast<std::size_t>(mumps_.n) * static_cast<std::size_t>(columns);
    std::copy(b, b + values, x);
    mumps_.rhs = x;
    mumps_.nrhs = columns;
    mumps_.lrhs = mumps_.n;
    run(solution);
    const FactorResult done = result();
    return {done ? SolveStatus::ok : SolveStatus::failed, 0, 0, done.message};
  }

  FactorResult result() const {
    const int status = info(1);
    if (status >= 0) return {};
    const std::string message = "MUMPS failed, status " + std::to_string(status);
    if (status == no_memory) return {FactorStatus::out_of_memory, -1, message};
    if (status == not_positive || status == numerically_singular)
      return {FactorStatus::not_positive_definite, -1, message};
    return {FactorStatus::failed, -1, message};
  }

  Options options_;
  KeptOrdering ordering_;
  DMUMPS_STRUC_C mumps_{};
  std::vector<MUMPS_INT> row_, column_, position_;  // counted from 1
};

}  // namespace

void register_mumps() {
  register_solver("mumps", [](const Options& options) { return std::make_unique<MumpsSolver>(options); });
}

}  // namespace isostretch::sparse::bench
