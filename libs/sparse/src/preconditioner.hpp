#pragma once

#include "node_system.hpp"

#include <isostretch/sparse/solver.hpp>

#include <memory>

namespace isostretch::sparse {

// What conjugate gradients multiply residuals with: a fixed symmetric positive definite approximation of the
// inverse. Vectors are padded ones of the NodeSystem.
class PreconditionerMethod {
 public:
  PreconditionerMethod() = default;
  virtual ~PreconditionerMethod();
  PreconditionerMethod(const PreconditionerMethod&) = delete;
  PreconditionerMethod& operator=(const PreconditionerMethod&) = delete;

  // Once per pattern, and for every matrix. A matrix seen to be indefinite is a status. A failed factorize()
  // leaves nothing to apply.
  virtual FactorResult analyze(const SymmetricMatrix& A, const NodeSystem& system);
  virtual FactorResult factorize(const NodeSystem& system, const Coordinates& coordinates) = 0;
  virtual void apply(const double* r, double* z) = 0;  // z = M^-1 r

  // How many multiplications a solve may take with a preconditioner made for an earlier matrix before it is
  // made anew; 0: it is made for every matrix.
  virtual int stale_iterations() const { return 0; }
  virtual void report(Statistics&) const {}

 protected:
  // "not positive definite", with the caller's number of the unknown; slot -1: not known.
  static FactorResult not_positive_definite(const NodeSystem& system, int slot, const char* where);
};

std::unique_ptr<PreconditionerMethod> make_preconditioner(const Options& options);

}  // namespace isostretch::sparse
