#include "preconditioner.hpp"

#include "block_diagonal.hpp"
#include "incomplete_cholesky.hpp"
#include "multigrid.hpp"
#include "stale_cholesky.hpp"

#include <string>

namespace isostretch::sparse {

PreconditionerMethod::~PreconditionerMethod() = default;

FactorResult PreconditionerMethod::analyze(const SymmetricMatrix&, const NodeSystem&) {
  return {};
}

FactorResult PreconditionerMethod::not_positive_definite(const NodeSystem& system, int slot,
                                                         const char* where) {
  const int column = slot < 0 ? -1 : system.unknown_of(slot);
  return {FactorStatus::not_positive_definite, column,
          "not positive definite: no positive pivot in column " + std::to_string(column) + where};
}

std::unique_ptr<PreconditionerMethod> make_preconditioner(const Options& options) {
  switch (options.pcg_preconditioner) {
    case Preconditioner::jacobi:
    case Preconditioner::block_jacobi:
      return std::make_unique<BlockDiagonal>(options.pcg_preconditioner);
    case Preconditioner::incomplete_cholesky:
      return std::make_unique<IncompleteCholesky>();
    case Preconditioner::stale_cholesky:
      return std::make_unique<StaleCholesky>(options);
    case Preconditioner::amg:
      break;
  }
  return std::make_unique<Multigrid>(options);
}

}  // namespace isostretch::sparse
