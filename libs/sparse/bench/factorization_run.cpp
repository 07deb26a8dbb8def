#include "factorization_run.hpp"

#include "json_line.hpp"
#include "threads.hpp"

#include "../tests/matrices.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/isa.hpp>
#include <isostretch/core/timer.hpp>

#include <dlfcn.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace isostretch::sparse::bench {
namespace {

constexpr int several = 8;  // right-hand sides

// Repeats a phase, which returns its seconds or throws Error. Time that it takes besides counts for the
// limit.
template <class Phase>
double median_seconds(const Run& run, const Phase& phase) {
  std::vector<double> seconds;
  const Timer timer;
  do {
    seconds.push_back(phase());
  } while (static_cast<int>(seconds.size()) < run.repetitions && timer.seconds() < run.seconds);
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(seconds.begin(), middle, seconds.end());
  return *middle;
}

// Bytes that the system accounts to this process under a name of /proc/self/status; 0 where it does not.
double bytes_of_process(const std::string& name) {
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0;
  while (status >> word)
    if (word == name) status >> kilobytes;
  return 1024 * kilobytes;
}

// The processor whose kernels OpenBLAS has chosen; empty for another BLAS, and for none.
std::string blas_kernels() {
  using CoreName = char* (*)();
  const auto core_name = reinterpret_cast<CoreName>(::dlsym(RTLD_DEFAULT, "openblas_get_corename"));
  return core_name ? core_name() : "";
}

void require(bool done, const std::string& message) {
  if (!done) throw Error(message);
}

// The phases of one solver, in the order in which a program meets them.
class Phases {
 public:
  Phases(const SymmetricMatrix& A, const Run& run) : A_(A), run_(run), solver_(make_solver(run.options)) {
    std::vector<int> last;
    for (int i = 0; i < run.last; ++i)
      last.push_back(static_cast<int>(static_cast<long long>(i) * A.size / run.last));
    solver_->set_last(std::move(last));
  }

  void analyze(JsonLine& line) {
    // Ordering and the rest are parts of the same calls.
    std::vector<double> ordering;
    const auto analysis = [&] {
      const Statistics before = solver_->statistics();
      const FactorResult result = solver_->analyze(A_);
      require(static_cast<bool>(result), result.message);
      const Statistics& after = solver_->statistics();
      ordering.push_back(after.ordering_seconds - before.ordering_seconds);
      return after.analyze_seconds - before.analyze_seconds - ordering.back();
    };
    line.add("first_analysis_seconds", analysis());
    line.add("analysis_seconds", median_seconds(run_, analysis));
    std::sort(ordering.begin(), ordering.end());
    line.add("ordering_seconds", ordering[ordering.size() / 2]);
  }

  void factorize(JsonLine& line) {
    const auto factorization = [&](FactorResult (Solver::*factorize)(const SymmetricMatrix&)) {
      return [&, factorize] {
        const double before = solver_->statistics().factorize_seconds;
        const FactorResult result = (*solver_.*factorize)(A_);
        require(static_cast<bool>(result), result.message);
        return solver_->statistics().factorize_seconds - before;
      };
    };
    line.add("first_factorization_seconds", factorization(&Solver::factorize)());
    line.add("factorization_seconds", median_seconds(run_, factorization(&Solver::factorize)));
    if (run_.last > 0)
      line.add("refactorization_seconds", median_seconds(run_, factorization(&Solver::refactorize)));
  }

  void solve(JsonLine& line) {
    const Eigen::VectorXd b = test::random_vector(several * A_.size, 1);
    Eigen::VectorXd x(b.size());
    const auto solution = [&](int columns) {
      return [&, columns] {
        const double before = solver_->statistics().solve_seconds;
        const SolveResult result = solver_->solve_columns(b.data(), x.data(), columns);
        require(static_cast<bool>(result), result.message);
        return solver_->statistics().solve_seconds - before;
      };
    };
    solution(1)();
    line.add("solve_seconds", median_seconds(run_, solution(1)));
    solution(several)();
    line.add("eight_solves_seconds", median_seconds(run_, solution(several)));
    line.add("residual", test::relative_residual(A_, x.tail(A_.size), b.tail(A_.size)));
  }

  void describe(JsonLine& line) const {
    const Statistics& statistics = solver_->statistics();
    line.add("operations", statistics.factor_flops);
    line.add("factor_entries", statistics.factor_nonzeros);
    line.add("solver_bytes", statistics.factor_bytes);
  }

 private:
  const SymmetricMatrix& A_;
  const Run& run_;
  std::unique_ptr<Solver> solver_;
};

}  // namespace

std::string measure(const SymmetricMatrix& A, const std::string& matrix, const Run& run) {
  set_threads(run.threads);
  JsonLine line;
  line.add("matrix", matrix);
  line.add("unknowns", A.size);
  line.add("matrix_entries", A.nonzeros());
  line.add("solver", std::string(backend_name(run.options.backend)));
  line.add("ordering", std::string(ordering_name(run.options.ordering)));
  line.add("threads", run.threads);
  line.add("level", std::string(isa_name(active_isa())));
  line.add("blas_kernels", blas_kernels());
  line.add("bytes_before", bytes_of_process("VmRSS:"));
  try {
    Phases phases(A, run);
    phases.analyze(line);
    phases.factorize(line);
    phases.solve(line);
    phases.describe(line);
  } catch (const std::exception& error) {
    line.add("error", std::string(error.what()));
  }
  line.add("peak_bytes", bytes_of_process("VmHWM:"));
  return line.text();
}

}  // namespace isostretch::sparse::bench
