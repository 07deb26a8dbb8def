#pragma once

#include <isostretch/core/option_fields.hpp>

#include <string_view>
#include <vector>

namespace isostretch::sparse {

// automatic: a factorization, by CHOLMOD where it was compiled in (supernodal or simplicial by the work per
// entry of the factor), by Eigen otherwise; for tetrahedral meshes whose factorization would take too long
// (automatic_max_flops) or would not fit into memory, pcg with algebraic multigrid. CHOLMOD's supernodal
// module is under the GPL: a program that links it falls under it too; configure with
// ISOSTRETCH_WITH_SUITESPARSE=OFF to leave CHOLMOD out.
// Values beyond the last are those of register_solver() (solver.hpp).
enum class Backend { automatic, cholmod_supernodal, cholmod_simplicial, eigen_ldlt, pcg };
/// Returns the back end of options as a choice by name: those built in, compiled in or not, and those
/// registered.
ChoiceSlot choice_slot(Backend& backend);

// automatic: see README.md for the measurements behind the choice. metis needs CHOLMOD.
enum class Ordering { automatic, amd, metis, natural };
constexpr ChoiceNames<Ordering, 4> choice_names(Ordering) {
  return {{{"automatic", Ordering::automatic},
           {"amd", Ordering::amd},
           {"metis", Ordering::metis},
           {"natural", Ordering::natural}}};
}

// jacobi, block_jacobi: the diagonal, or the blocks of the groups on it.
// incomplete_cholesky: IC(0) of the blocks, with a shift where it breaks down.
// stale_cholesky: the factor of an earlier matrix of the pattern, renewed by stale_max_iterations.
// amg: algebraic multigrid by smoothed aggregation, renewed by the same rule. It wants the positions of nodes
// (Solver::set_coordinates).
enum class Preconditioner { jacobi, block_jacobi, incomplete_cholesky, stale_cholesky, amg };
constexpr ChoiceNames<Preconditioner, 5> choice_names(Preconditioner) {
  return {{{"jacobi", Preconditioner::jacobi},
           {"block_jacobi", Preconditioner::block_jacobi},
           {"incomplete_cholesky", Preconditioner::incomplete_cholesky},
           {"stale_cholesky", Preconditioner::stale_cholesky},
           {"amg", Preconditioner::amg}}};
}

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

  /// Visits (Field, member) for each option, see core/option_fields.hpp.
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit(Field{"backend", "Solver of the linear systems"}, self.backend);
    visit(Field{"ordering", "Order in which direct solvers eliminate unknowns"}, self.ordering);
    visit(Field{"preconditioner", "Preconditioner of the backend pcg"}, self.pcg_preconditioner);
    visit(
        Field{
            "automatic_max_flops",
            "The automatic choice factorises a matrix of a body when that takes no more operations than this",
            finite(at_least(0)), "operations", true},
        self.automatic_max_flops);
    visit(Field{"pcg_tolerance", "Relative residual at which pcg ends", inside(0, 1), "", true},
          self.pcg_tolerance);
    visit(Field{"pcg_max_iterations",
                "Multiplications by the matrix after which pcg ends; 0: 10 times the unknowns, and 100",
                at_least(0), "", true},
          self.pcg_max_iterations);
    visit(Field{"stale_max_iterations",
                "Multiplications after which stale_cholesky and amg renew the preconditioner; 0: by its cost",
                at_least(0), "", true},
          self.stale_max_iterations);
  }
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
