#pragma once

#include <isostretch/core/error.hpp>
#include <isostretch/sparse/matrix.hpp>
#include <isostretch/sparse/options.hpp>

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::sparse {

/// How an analysis or a factorization ended.
enum class FactorStatus { ok, not_positive_definite, out_of_memory, failed };

/// How an analysis or a factorization ended, and why.
struct FactorResult {
  /// How the factorization ended.
  FactorStatus status = FactorStatus::ok;
  /// Where the first non-positive pivot was met, in the caller's numbering; -1: not known.
  int column = -1;
  std::string message;  ///< empty when ok
  /// Returns whether the factorization succeeded.
  explicit operator bool() const { return status == FactorStatus::ok; }
};

/// How a solution ended.
///
/// not_converged: x is the best there is, an approximation that a Newton method can use. So it is with
/// not_positive_definite: x is the iterate before the direction of negative curvature (truncated conjugate
/// gradients, Steihaug 1983), zero if that was the first direction; otherwise b . x > 0.
enum class SolveStatus { ok, not_converged, not_positive_definite, failed };

/// How a solution ended, and how good it is.
struct SolveResult {
  /// How the solve ended.
  SolveStatus status = SolveStatus::ok;
  int iterations = 0;  ///< pcg: multiplications by A; summed over the right-hand sides
  /// pcg: largest |b - A x| / |b|; direct solvers do not measure it and say 0.
  double relative_residual = 0;
  std::string message;  ///< empty when ok
  /// Returns whether the solve succeeded.
  explicit operator bool() const { return status == SolveStatus::ok; }
};

/// The work of a solver so far, and how it was done.
struct Statistics {
  Backend backend = Backend::automatic;  ///< the one at work, never automatic after analyze()
  Preconditioner preconditioner = Preconditioner::jacobi;  ///< pcg
  Ordering ordering = Ordering::automatic;                 ///< the one used, never automatic after analyze()
  double factor_nonzeros = 0;  ///< nnz(L) with the diagonal, without supernodal padding
  /// Operations of one factorization; 0 where the back end does not say.
  double factor_flops = 0;
  /// Bytes of the factor and of what factorizations need besides, as the analysis predicts them; 0 where the
  /// back end does not say.
  double factor_bytes = 0;
  double ordering_seconds = 0;  ///< part of analyze_seconds
  double analyze_seconds = 0;   ///< seconds and calls add up over the life of the solver
  /// Time of numeric factorizations, in seconds.
  double factorize_seconds = 0;
  /// Time of solves, in seconds.
  double solve_seconds = 0;
  int analyze_calls = 0;  ///< with those of update_pattern()
  int orderings = 0;      ///< fill-reducing orderings computed
  /// The number of numeric factorizations.
  int factorize_calls = 0;
  /// The number of solves.
  int solve_calls = 0;
  int factorizations = 0;   ///< factors and preconditioners made: fewer than calls where stale ones serve
  int multiplications = 0;  ///< pcg: by A, over all solves
};

/// Solves A x = b for symmetric positive definite A:
///
///   auto solver = make_solver({});
///   solver->analyze(A);                       ///< once per sparsity pattern
///   if (solver->factorize(A)) solver->solve(b, x);
///
/// A that is not positive definite is a status, found at the first non-positive pivot (eigen_ldlt: after a
/// whole factorization; pcg: possibly only while solving), and leaves the solver ready for the next
/// factorize(). Misuse throws Error: a malformed matrix, another pattern than analyzed, NaN (row and column
/// are named), solve() without a factorization. One solver is used by one thread at a time; BLAS threading is
/// the environment's business (OPENBLAS_NUM_THREADS), so do not call it from inside a parallel region.
class Solver {
 public:
  virtual ~Solver();
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  /// Computes ordering and symbolic factorization. Values are not looked at. out_of_memory or failed are
  /// repeated by factorize() until the next analyze().
  FactorResult analyze(const SymmetricMatrix& A);

  /// Takes a pattern of the same size that differs a little from the one analyzed, as analyze() does but
  /// without a new ordering: direct solvers keep theirs and renew the symbolic factorization, until the
  /// factor has grown so much that a new ordering pays; others may analyze anew. The statuses are those of
  /// analyze(). Throws Error for a malformed matrix, for another size or other groups, and before analyze().
  FactorResult update_pattern(const SymmetricMatrix& A);

  /// Factorises a matrix with the pattern analyzed. Its values are not referred to later.
  FactorResult factorize(const SymmetricMatrix& A);

  /// Factorises a matrix that differs from that of the last factorize() in nothing but entries both of whose
  /// unknowns were given to set_last(), which is not checked. The multifrontal back end takes from that
  /// factorization what has not changed, and gives the bits of factorize(). Others factorise anew, and so
  /// does it without a successful factorize() before.
  FactorResult refactorize(const SymmetricMatrix& A);

  /// Solves for one right-hand side. x is resized here, in the caller's code: memory of an Eigen object must
  /// not change hands between code compiled with different instruction sets.
  SolveResult solve(const Eigen::Ref<const Eigen::VectorXd>& b, Eigen::VectorXd& x) {
    require_rows(b.rows());
    x.resize(b.rows());
    return solve_columns(b.data(), x.data(), 1);
  }

  /// Solves for several right-hand sides, one a column.
  SolveResult solve(const Eigen::MatrixXd& B, Eigen::MatrixXd& X) {
    require_rows(B.rows());
    X.resize(B.rows(), B.cols());
    return solve_columns(B.data(), X.data(), static_cast<int>(B.cols()));
  }

  /// Solves on raw column-major arrays of size x columns that do not overlap.
  SolveResult solve_columns(const double* b, double* x, int columns);

  /// Sets |b - A x| / |b| that an iterative back end is to reach in solves from here on, in place of
  /// Options::pcg_tolerance: inexact Newton methods ask for few digits at first. Direct solvers do what they
  /// always do. Throws Error unless 0 < tolerance < 1.
  void set_tolerance(double tolerance);

  /// Says where nodes are: node group[i] of the matrix at positions[dim * group[i]], dim 2 or 3; pinned nodes
  /// count, so that `nodes` is larger than any group. axis[i] is the axis that unknown i stands for; it may
  /// be left out, and matters where pins leave a node fewer unknowns than axes. Optional, and used by the amg
  /// preconditioner: it learns rotations from it, without which elastic bodies converge slowly. Positions are
  /// copied, and used by the factorize() calls that follow; axes count from the next analyze() on.
  void set_coordinates(const double* positions, int dim, int nodes, const std::vector<int>& axis = {});

  /// Says which unknowns a direct solver is to eliminate after all others, those of the list in its order:
  /// unknowns whose entries change from one matrix to the next while others stay, as pins and contacts do
  /// (see refactorize()), or whose Schur complement is wanted. analyze() is due after it. It may cost fill; a
  /// few thousand are no burden. Throws Error for a negative unknown and one given twice, and analyze() does
  /// for one that the matrix has not.
  void set_last(std::vector<int> unknowns);

  /// Computes the Schur complement of the unknowns of set_last(), in their order, all its entries in columns
  /// of as many values: what is left of their rows and columns when all other unknowns have been eliminated.
  /// Does nothing where there are none. Throws Error without a factorization and for a back end other than
  /// `multifrontal`, which `automatic` may have chosen, and std::bad_alloc where there is no memory.
  void schur_complement(double* values) const;

  /// Returns what the solver has done so far.
  const Statistics& statistics() const noexcept { return statistics_; }

 protected:
  Solver();

  /// The part that a back end supplies. Matrices are validated, finite and never empty; x and b have the
  /// right sizes.
  virtual FactorResult do_analyze(const SymmetricMatrix& A) = 0;
  /// Analyzes a pattern that is near to the one before. Analyzes anew unless overridden.
  virtual FactorResult do_update_pattern(const SymmetricMatrix& A) { return do_analyze(A); }
  /// Factorises the matrix, whose pattern was analyzed.
  virtual FactorResult do_factorize(const SymmetricMatrix& A) = 0;
  /// Factorises anew unless overridden.
  virtual FactorResult do_refactorize(const SymmetricMatrix& A) { return do_factorize(A); }
  /// Solves for so many right-hand sides, column by column.
  virtual SolveResult do_solve(const double* b, double* x, int columns) = 0;
  /// Arguments are valid.
  virtual void do_set_tolerance(double) {}
  /// Takes the positions of nodes, for back ends that use them.
  virtual void do_set_coordinates(const double*, int, int, const std::vector<int>&) {}

  /// Returns whether the back end has computed the Schur complement.
  virtual bool do_schur_complement(double*) const { return false; }
  /// Returns the unknowns to be eliminated last.
  const std::vector<int>& last() const { return last_; }

  /// The counts and times that statistics() returns.
  Statistics statistics_;

 private:
  void require_rows(Eigen::Index rows) const;
  void require_same_pattern(const SymmetricMatrix& A) const;
  template <class Analysis>
  FactorResult take_pattern(const SymmetricMatrix& A, const Analysis& analysis);
  template <class Factorization>
  FactorResult take_values(const SymmetricMatrix& A, const Factorization& factorization);
  void log_analysis() const;
  friend std::unique_ptr<Solver> make_solver(const Options& options);

  enum class State { empty, analyzed, factorized };
  State state_ = State::empty;
  FactorResult analysis_;
  int size_ = 0;
  std::vector<int> column_start_;
  std::vector<int> row_;
  std::vector<int> group_;
  std::vector<int> last_;
};

/// Makes a solver, from the options as make_solver() was given them.
using SolverFactory = std::function<std::unique_ptr<Solver>(const Options&)>;

/// Gives a linear solver a name, which is then accepted, listed and written wherever those of the built-in
/// back ends are, and returns the back end that stands for it in `Options`. Call it before the name is asked
/// for, as at the start of a program; it stays until the program ends. Throws Error for an empty name, a name
/// that is taken, and a factory that is empty.
Backend register_solver(std::string_view name, SolverFactory factory);

/// Returns a solver as the options describe it. Throws Error when the back end or the ordering is not
/// compiled in, when an option is out of range, and when the factory of a registered solver makes none.
std::unique_ptr<Solver> make_solver(const Options& options = {});

}  // namespace isostretch::sparse
