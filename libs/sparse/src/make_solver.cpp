#include "automatic_solver.hpp"
#include "backends.hpp"
#include "cholmod_solver.hpp"
#include "direct_solver.hpp"
#include "eigen_solver.hpp"
#include "multifrontal_solver.hpp"
#include "pcg_solver.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/to_text.hpp>

#include <algorithm>
#include <string>

namespace isostretch::sparse {
namespace {

void require_valid(const Options& options) {
  if (!is_available(options.backend))
    throw Error("solver back end '" + std::string(backend_name(options.backend)) + "' is not compiled in");
  const auto& orderings = available_orderings();
  if (options.ordering != Ordering::automatic &&
      std::find(orderings.begin(), orderings.end(), options.ordering) == orderings.end())
    throw Error("ordering '" + std::string(ordering_name(options.ordering)) + "' is not compiled in");
  if (!(options.pcg_tolerance > 0 && options.pcg_tolerance < 1))
    throw Error("pcg_tolerance is " + to_text(options.pcg_tolerance) + ", not between 0 and 1");
  if (options.pcg_max_iterations < 0)
    throw Error("pcg_max_iterations is negative: " + std::to_string(options.pcg_max_iterations));
  if (options.stale_max_iterations < 0)
    throw Error("stale_max_iterations is negative: " + std::to_string(options.stale_max_iterations));
  if (!(options.automatic_max_flops >= 0))
    throw Error("automatic_max_flops is " + std::to_string(options.automatic_max_flops) + ", not 0 or more");
}

}  // namespace

std::unique_ptr<Solver> make_direct_solver(const Options& options) {
  if (options.backend == Backend::eigen_ldlt) return make_eigen_solver(options);
#if defined(ISOSTRETCH_WITH_CHOLMOD)
  if (options.backend == Backend::cholmod_supernodal || options.backend == Backend::cholmod_simplicial)
    return make_cholmod_solver(options);
#endif
  return make_multifrontal_solver(options);
}

std::unique_ptr<Solver> make_solver(const Options& options) {
  require_valid(options);
  if (auto registered = make_registered_solver(options)) {
    registered->statistics_.backend = options.backend;
    return registered;
  }
  if (options.backend == Backend::pcg) return make_pcg_solver(options);
  if (options.backend == Backend::automatic) return make_automatic_solver(options);
  return make_direct_solver(options);
}

}  // namespace isostretch::sparse
