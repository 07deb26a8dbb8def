#pragma once

#include <string_view>
#include <vector>

namespace isostretch::sparse {

// automatic: CHOLMOD where it was compiled in, supernodal or simplicial by the work per entry of the factor;
// Eigen otherwise. CHOLMOD's supernodal module is under the GPL: a program that links it falls under it too;
// configure with ISOSTRETCH_WITH_SUITESPARSE=OFF to leave CHOLMOD out.
enum class Backend { automatic, cholmod_supernodal, cholmod_simplicial, eigen_ldlt, pcg };

// automatic: see README.md for the measurements behind the choice. metis needs CHOLMOD.
enum class Ordering { automatic, amd, metis, natural };

enum class Preconditioner { jacobi, block_jacobi };

struct Options {
  Backend backend = Backend::automatic;
  Ordering ordering = Ordering::automatic;  // not used by pcg

  // pcg stops at |b - A x| <= pcg_tolerance |b| (2-norms, true residual) or after pcg_max_iterations
  // multiplications by A; 0 means 10 * size + 100.
  double pcg_tolerance = 1e-8;
  int pcg_max_iterations = 0;
  Preconditioner pcg_preconditioner = Preconditioner::block_jacobi;  // one block per group
};

// Names as on a command line: the enumerator's own. The inverse throws Error listing the names there are.
std::string_view backend_name(Backend backend) noexcept;
std::string_view ordering_name(Ordering ordering) noexcept;
std::string_view preconditioner_name(Preconditioner preconditioner) noexcept;
Backend backend_from_name(std::string_view name);
Ordering ordering_from_name(std::string_view name);
Preconditioner preconditioner_from_name(std::string_view name);

// Compiled in, without `automatic`; the first is the preferred one.
const std::vector<Backend>& available_backends();
bool is_available(Backend backend);
// Orderings that can be asked for, without `automatic`.
const std::vector<Ordering>& available_orderings();

}  // namespace isostretch::sparse
