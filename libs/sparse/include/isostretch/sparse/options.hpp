#pragma once

#include <isostretch/core/option_fields.hpp>

#include <string_view>
#include <vector>

namespace isostretch::sparse {

/// The solvers of linear systems. Values beyond the last are those of register_solver() (solver.hpp).
enum class Backend {
  /// A factorization, multifrontal. For tetrahedral meshes whose factorization would take too long
  /// (automatic_max_flops) or would not fit into memory, pcg with algebraic multigrid.
  automatic,
  /// CHOLMOD's supernodal module. It is under the GPL, and a program that links it falls under it too;
  /// configure with ISOSTRETCH_WITH_SUITESPARSE=OFF to leave CHOLMOD out.
  cholmod_supernodal,
  cholmod_simplicial,  ///< CHOLMOD's simplicial factorization.
  /// Our own multifrontal factorization (library cholesky), in which subtrees and large fronts are shared
  /// among threads.
  multifrontal,
  eigen_ldlt,  ///< Eigen's simplicial factorization.
  pcg          ///< Conjugate gradients with a preconditioner.
};
/// Returns the back end of options as a choice by name: those built in, compiled in or not, and those
/// registered.
ChoiceSlot choice_slot(Backend& backend);

/// The orders in which direct solvers eliminate unknowns.
enum class Ordering {
  automatic,  ///< By size and dimension; README.md has the measurements behind the choice.
  amd,        ///< Approximate minimum degree: quick.
  metis,      ///< Nested dissection, which leaves less to factorise; needs METIS.
  natural     ///< The order of the unknowns.
};
/// Returns the names of the orderings on command lines and in scenes.
constexpr ChoiceNames<Ordering, 4> choice_names(Ordering) {
  return {{{"automatic", Ordering::automatic},
           {"amd", Ordering::amd},
           {"metis", Ordering::metis},
           {"natural", Ordering::natural}}};
}

/// The preconditioners of conjugate gradients.
enum class Preconditioner {
  jacobi,               ///< The diagonal.
  block_jacobi,         ///< The blocks of the groups on the diagonal.
  incomplete_cholesky,  ///< IC(0) of the blocks, with a shift where it breaks down.
  stale_cholesky,       ///< The factor of an earlier matrix of the pattern, renewed by stale_max_iterations.
  /// Algebraic multigrid by smoothed aggregation, renewed by stale_max_iterations. It wants the positions of
  /// nodes (Solver::set_coordinates).
  amg
};
/// Returns the names of the preconditioners on command lines and in scenes.
constexpr ChoiceNames<Preconditioner, 5> choice_names(Preconditioner) {
  return {{{"jacobi", Preconditioner::jacobi},
           {"block_jacobi", Preconditioner::block_jacobi},
           {"incomplete_cholesky", Preconditioner::incomplete_cholesky},
           {"stale_cholesky", Preconditioner::stale_cholesky},
           {"amg", Preconditioner::amg}}};
}

/// The options of linear solvers; each back end looks at its own.
struct Options {
  /// The solver.
  Backend backend = Backend::automatic;
  /// The order of elimination; pcg does not use it.
  Ordering ordering = Ordering::automatic;

  /// Operations up to which Backend::automatic factorises a matrix of the 3D kind.
  double automatic_max_flops = 4e9;

  /// Relative residual |b - A x| / |b| (2-norms, true residual) at which pcg stops.
  double pcg_tolerance = 1e-8;
  /// Multiplications by A after which pcg stops; 0: 10 * size + 100.
  int pcg_max_iterations = 0;
  /// The preconditioner of pcg.
  Preconditioner pcg_preconditioner = Preconditioner::block_jacobi;

  /// Multiplications that a solve may take before stale_cholesky and amg renew their preconditioner for the
  /// matrices that follow. 0: 40 for amg, and by the work of the factorization for stale_cholesky, 4 and more
  /// (README.md).
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

/// Returns the name of a back end, or that given to register_solver().
std::string_view backend_name(Backend backend) noexcept;
/// Returns the name of an ordering.
std::string_view ordering_name(Ordering ordering) noexcept;
/// Returns the name of a preconditioner.
std::string_view preconditioner_name(Preconditioner preconditioner) noexcept;
/// Returns the back end of that name. Throws Error listing the names there are if there is none.
Backend backend_from_name(std::string_view name);
/// Returns the ordering of that name. Throws Error listing the names there are if there is none.
Ordering ordering_from_name(std::string_view name);
/// Returns the preconditioner of that name. Throws Error listing the names there are if there is none.
Preconditioner preconditioner_from_name(std::string_view name);

/// Returns the back ends compiled in, without `automatic` and the preferred one first, and then those
/// registered.
std::vector<Backend> available_backends();
/// Returns whether a back end was compiled in or registered; `automatic` always was.
bool is_available(Backend backend);
/// All of them: none depends on what is compiled in.
const std::vector<Preconditioner>& all_preconditioners();
/// Orderings that can be asked for, without `automatic`.
const std::vector<Ordering>& available_orderings();

}  // namespace isostretch::sparse
