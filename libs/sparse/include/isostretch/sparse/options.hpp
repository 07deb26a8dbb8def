#pragma once

#include <string_view>
#include <vector>

namespace isostretch::sparse {

// automatic: a factorization, by CHOLMOD where it was compiled in (supernodal or simplicial by the work per
// entry of the factor), by Eigen otherwise; for tetrahedral meshes whose factorization would take too long
// (automatic_max_flops) or would not fit into memory, pcg with algebraic multigrid. CHOLMOD's supernodal
// module is under the GPL: a program that links it falls under it too; configure with
// ISOSTRETCH_WITH_SUITESPARSE=OFF to leave CHOLMOD out.
/// Values beyond the last are those of register_solver() (solver.hpp).
enum class Backend { automatic, cholmod_supernodal, cholmod_simplicial, eigen_ldlt, pcg };

// automatic: see README.md for the measurements behind the choice. metis needs CHOLMOD.
enum class Ordering { automatic, amd, metis, natural };

// jacobi, block_jacobi: the diagonal, or the blocks of the groups on it.
// incomplete_cholesky: IC(0) of the blocks, with a shift where it breaks down.
// stale_cholesky: the factor of an earlier matrix of the pattern, renewed by stale_max_iterations.
// amg: algebraic multigrid by smoothed aggregation, renewed by the same rule. It wants the positions of nodes
// (Solver::set_coordinates).
enum class Preconditioner { jacobi, block_jacobi, incomplete_cholesky, stale_cholesky, amg };

struct Options {
  Backend backend = Backend::automatic;
  Ordering ordering = Ordering::automatic;  // not used by pcg

  // Backend::automatic factorises a matrix of the 3D kind when that takes no more operations than this.
  double automatic_max_flops = 4e9;

  // pcg stops at |b - A x| <= pcg_tolerance |b| (2-norms, true residual) or after pcg_max_iterations
  // multiplications by A; 0 means 10 * size + 100.
  double pcg_tolerance = 1e-8;
  int pcg_max_iterations = 0;
  Preconditioner pcg_preconditioner = Preconditioner::block_jacobi;

  // stale_cholesky and amg: a preconditioner is kept for the matrices that follow until a solve takes more
  // multiplications than this, or fails. 0: 40 for amg, and by the work of the
  // factorization for stale_cholesky, 4 and more (README.md).
  int stale_max_iterations = 0;

  friend bool operator==(const Options&, const Options&) = default;
};

// Names as on a command line: the enumerator's own, and that given to register_solver(). The inverse throws
// Error listing the names there are.
std::string_view backend_name(Backend backend) noexcept;
std::string_view ordering_name(Ordering ordering) noexcept;
std::string_view preconditioner_name(Preconditioner preconditioner) noexcept;
Backend backend_from_name(std::string_view name);
Ordering ordering_from_name(std::string_view name);
Preconditioner preconditioner_from_name(std::string_view name);

/// Returns the back ends compiled in, without `automatic` and the preferred one first, and then those
/// registered.
std::vector<Backend> available_backends();
/// Returns whether a back end was compiled in or registered; `automatic` always was.
bool is_available(Backend backend);
// All of them: none depends on what is compiled in.
const std::vector<Preconditioner>& all_preconditioners();
// Orderings that can be asked for, without `automatic`.
const std::vector<Ordering>& available_orderings();

}  // namespace isostretch::sparse
