#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/sparse/solver.hpp>

#include <algorithm>
#include <cmath>
#include <new>
#include <string>
#include <utility>

namespace isostretch::sparse {
namespace {

void require_finite(const double* b, int rows, int columns) {
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i)
      if (!std::isfinite(b[static_cast<std::size_t>(j) * rows + i]))
        throw Error("sparse solver: right-hand side " + std::to_string(j) + " is not finite in row " +
                    std::to_string(i));
}

}  // namespace

Solver::Solver() = default;
Solver::~Solver() = default;

template <class Analysis>
FactorResult Solver::take_pattern(const SymmetricMatrix& A, const Analysis& analysis) {
  const ScopedTimer timer(statistics_.analyze_seconds);
  ++statistics_.analyze_calls;
  A.validate();
  state_ = State::empty;
  for (const int unknown : last_)
    if (unknown >= A.size)
      throw Error("sparse solver: unknown " + std::to_string(unknown) + " cannot be the last of " +
                  std::to_string(A.size));
  size_ = A.size;
  try {
    column_start_ = A.column_start;
    row_ = A.row;
    group_ = A.group;
    analysis_ = size_ == 0 ? FactorResult{} : analysis();
  } catch (const std::bad_alloc&) {
    analysis_ = {FactorStatus::out_of_memory, -1, "out of memory in the symbolic analysis"};
  }
  state_ = State::analyzed;
  log_analysis();
  return analysis_;
}

FactorResult Solver::analyze(const SymmetricMatrix& A) {
  state_ = State::empty;
  return take_pattern(A, [&] { return do_analyze(A); });
}

FactorResult Solver::update_pattern(const SymmetricMatrix& A) {
  if (state_ == State::empty) throw Error("sparse solver: update_pattern() needs an analyze() first");
  if (A.size != size_ || A.group != group_)
    throw Error("sparse solver: update_pattern() of a matrix of size " + std::to_string(A.size) +
                ", after analyze() of size " + std::to_string(size_) + ": size and groups stay");
  // What an analysis that failed has left is nothing to start from.
  if (!analysis_) return analyze(A);
  return take_pattern(A, [&] { return do_update_pattern(A); });
}

void Solver::log_analysis() const {
  log(LogLevel::debug, [this] {
    if (!analysis_)
      return "sparse: analysis of " + std::to_string(size_) + " unknowns failed: " + analysis_.message;
    std::string text = "sparse: " + std::to_string(size_) + " unknowns, " + std::to_string(row_.size()) +
                       " entries: " + std::string(backend_name(statistics_.backend));
    if (statistics_.backend == Backend::pcg)
      return text + " with " + std::string(preconditioner_name(statistics_.preconditioner));
    return text + ", ordering " + std::string(ordering_name(statistics_.ordering)) + ", factor of " +
           to_text(statistics_.factor_nonzeros) + " entries";
  });
}

template <class Factorization>
FactorResult Solver::take_values(const SymmetricMatrix& A, const Factorization& factorization) {
  const ScopedTimer timer(statistics_.factorize_seconds);
  ++statistics_.factorize_calls;
  if (state_ == State::empty) throw Error("sparse solver: factorize() needs an analyze() first");
  if (!analysis_) return analysis_;
  state_ = State::analyzed;
  require_same_pattern(A);
  A.require_finite();
  FactorResult result;
  try {
    if (size_ > 0) result = factorization();
  } catch (const std::bad_alloc&) {
    result = {FactorStatus::out_of_memory, -1, "out of memory in the factorization"};
  }
  if (result) state_ = State::factorized;
  return result;
}

FactorResult Solver::factorize(const SymmetricMatrix& A) {
  return take_values(A, [&] { return do_factorize(A); });
}

FactorResult Solver::refactorize(const SymmetricMatrix& A) {
  return take_values(A, [&] { return do_refactorize(A); });
}

SolveResult Solver::solve_columns(const double* b, double* x, int columns) {
  const ScopedTimer timer(statistics_.solve_seconds);
  ++statistics_.solve_calls;
  if (state_ != State::factorized) throw Error("sparse solver: solve() needs a successful factorize() first");
  require_finite(b, size_, columns);
  if (size_ == 0 || columns == 0) return {};
  return do_solve(b, x, columns);
}

void Solver::set_tolerance(double tolerance) {
  if (!(tolerance > 0 && tolerance < 1))
    throw Error("sparse solver: tolerance " + to_text(tolerance) + " is not between 0 and 1");
  do_set_tolerance(tolerance);
}

void Solver::set_coordinates(const double* positions, int dim, int nodes, const std::vector<int>& axis) {
  if (dim != 2 && dim != 3)
    throw Error("sparse solver: coordinates of dimension " + std::to_string(dim) + ", not 2 or 3");
  if (nodes < 0) throw Error("sparse solver: coordinates of " + std::to_string(nodes) + " nodes");
  for (int node = 0; node < nodes; ++node)
    for (int a = 0; a < dim; ++a)
      if (!std::isfinite(positions[static_cast<std::size_t>(dim) * node + a]))
        throw Error("sparse solver: a coordinate of node " + std::to_string(node) + " is not finite");
  do_set_coordinates(positions, dim, nodes, axis);
}

void Solver::set_last(std::vector<int> unknowns) {
  std::vector<int> sorted = unknowns;
  std::sort(sorted.begin(), sorted.end());
  if (!sorted.empty() && sorted.front() < 0)
    throw Error("sparse solver: unknown " + std::to_string(sorted.front()) + " cannot be the last");
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    throw Error("sparse solver: unknown " + std::to_string(*twice) + " cannot be the last twice");
  last_ = std::move(unknowns);
  state_ = State::empty;
}

void Solver::schur_complement(double* values) const {
  if (state_ != State::factorized)
    throw Error("sparse solver: schur_complement() needs a successful factorize() first");
  if (!last_.empty() && !do_schur_complement(values))
    throw Error("sparse solver: the back end " + std::string(backend_name(statistics_.backend)) +
                " computes no Schur complement");
}

void Solver::require_rows(Eigen::Index rows) const {
  if (rows != size_)
    throw Error("sparse solver: right-hand side has " + std::to_string(rows) + " rows, the matrix " +
                std::to_string(size_));
}

// Cheap (two comparisons of integer arrays), and the alternative is a wrong answer.
void Solver::require_same_pattern(const SymmetricMatrix& A) const {
  if (A.size != size_)
    throw Error("sparse solver: matrix of size " + std::to_string(A.size) + " after analyze() of size " +
                std::to_string(size_));
  if (A.column_start != column_start_ || A.row != row_ || A.value.size() != row_.size())
    throw Error("sparse solver: the pattern of the matrix is not the one given to analyze()");
}

}  // namespace isostretch::sparse
