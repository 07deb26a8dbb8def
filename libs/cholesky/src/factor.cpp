#include "elimination.hpp"
#include "threads.hpp"

#include <isostretch/core/error.hpp>

namespace isostretch::cholesky {

Factor::Factor(const Analysis& analysis) : elimination_(new Elimination(analysis)) {}
Factor::~Factor() = default;

std::int64_t Factor::bytes(int threads) const {
  return elimination_->bytes(threads > 0 ? threads : most_threads());
}

void Factor::limit_memory(std::int64_t bytes) {
  elimination_->most_bytes = bytes;
}

FactorizeResult Factor::factorize(const double* values) {
  return elimination_->factorize(values);
}

FactorizeResult Factor::refactorize(const double* values) {
  return elimination_->refactorize(values);
}

bool Factor::is_ready() const {
  return elimination_->ready;
}

void Factor::solve(const double* b, double* x, int columns) {
  if (!is_ready()) throw Error(ErrorKind::misuse, "cholesky: solve() without a factor");
  if (columns > 0) elimination_->solve(b, x, columns);
}

void Factor::schur_complement(double* values) const {
  if (!is_ready()) throw Error(ErrorKind::misuse, "cholesky: schur_complement() without a factor");
  elimination_->schur_complement(values);
}

}  // namespace isostretch::cholesky
