#pragma once

#include <isostretch/cholesky/analysis.hpp>

#include <cstdint>
#include <memory>

namespace isostretch::cholesky {

/// How a factorization ended.
enum class FactorizeStatus {
  ok,                     ///< There is a factor.
  not_positive_definite,  ///< A pivot is not positive.
  not_finite,             ///< A pivot is infinite or not a number: entries are, or they overflow on the way.
  out_of_memory           ///< There is no memory for the factor, or the limit does not allow it.
};

/// How a factorization ended, and where.
struct FactorizeResult {
  FactorizeStatus status = FactorizeStatus::ok;  ///< How it ended.
  /// The unknown whose pivot is not a positive number, the first of a fixed order that depends on the pattern
  /// alone; -1: none.
  int unknown = -1;
  /// Returns whether there is a factor.
  explicit operator bool() const { return status == FactorizeStatus::ok; }
};

/// The factor L of A = L L^T, A in the pattern of an analysis, by the multifrontal method (Duff, Reid 1983)
/// with dense kernels for small fronts. Subtrees of the elimination tree are factorised by threads of their
/// own (OpenMP), the fronts above them by all threads; results are the same bits for any number of threads.
/// Memory is taken at the first factorization and kept; later ones take none unless there are other threads.
class Factor {
 public:
  /// Takes an analysis, which must outlive the factor.
  explicit Factor(const Analysis& analysis);
  ~Factor();
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;

  /// Returns the bytes that factorizations take with so many threads, besides those of the analysis; 0: with
  /// those that the next one will have. Finding it out means planning where update matrices lie, which takes
  /// milliseconds once for a number of threads, and may throw std::bad_alloc.
  std::int64_t bytes(int threads = 0) const;
  /// Refuses factorizations that would take more bytes, without taking them; 0: no limit. Refactorizations
  /// take none and are not refused.
  void limit_memory(std::int64_t bytes);

  /// Factorises the matrix with these values, in the order of the pattern's entries. Without success there is
  /// no factor until the next call.
  FactorizeResult factorize(const double* values);
  /// Factorises a matrix that differs from that of the last factorize() in nothing but entries both of whose
  /// unknowns are among Analysis::last(), which is not checked, and takes from that factorization what has
  /// not changed. The factor is that of factorize(), to the bit. Without a successful factorize() before, or
  /// after one that has failed, it is factorize().
  FactorizeResult refactorize(const double* values);
  /// Returns whether there is a factor.
  bool is_ready() const;

  /// Solves A x = b for right-hand sides of size values each, one after the other; x may be b. Several are
  /// solved eight at a time. Throws Error where there is no factor, and std::bad_alloc where there is no
  /// memory for the solve.
  void solve(const double* b, double* x, int columns = 1);

  /// Computes what is left of the rows and columns of Analysis::last() when all other unknowns have been
  /// eliminated: the Schur complement S = A_ll - A_lo A_oo^-1 A_ol, all its entries in columns of
  /// last().size() values. Throws Error where there is no factor, and std::bad_alloc where there is no memory
  /// for it.
  void schur_complement(double* values) const;

 private:
  class Elimination;
  std::unique_ptr<Elimination> elimination_;
};

}  // namespace isostretch::cholesky
