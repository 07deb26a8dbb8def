#pragma once

#include "preconditioner.hpp"

#include <vector>

namespace isostretch::sparse {

// The Cholesky factor of an earlier matrix of the same pattern.
class StaleCholesky final : public PreconditionerMethod {
 public:
  explicit StaleCholesky(const Options& options);
  FactorResult analyze(const SymmetricMatrix& A, const NodeSystem& system) override;
  FactorResult factorize(const NodeSystem& system, const Coordinates& coordinates) override;
  void apply(const double* r, double* z) override;
  int stale_iterations() const override;
  void report(Statistics& statistics) const override;

 private:
  std::unique_ptr<Solver> factor_;
  int wanted_iterations_;
  SymmetricMatrix matrix_;
  const NodeSystem* system_ = nullptr;  // whose numbering vectors come in
  std::vector<double> right_, solution_;
};

}  // namespace isostretch::sparse
