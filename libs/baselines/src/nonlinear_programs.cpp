// Solvers of nonlinear programs: Ipopt and NLopt, in the table also where this is built without them.
#include "registry.hpp"

#if defined(ISOSTRETCH_WITH_IPOPT)
#include "ipopt_solvers.hpp"
#endif

namespace isostretch::baselines {
namespace {

constexpr std::string_view ipopt_source = "Waechter, Biegler 2006: filter line search, interior point";

}  // namespace

std::vector<Entry> ipopt_solvers() {
#if defined(ISOSTRETCH_WITH_IPOPT)
  const std::string needs;
  const Run minors = run_ipopt, feasible = run_ipopt_feasible, cone = run_ipopt_cone;
#else
  const std::string needs = "isostretch was built without Ipopt (Debian: coinor-libipopt-dev)";
  const Run minors = nullptr, feasible = nullptr, cone = nullptr;
#endif
  return {{{"ipopt", "Ipopt", ipopt_source, Kind::convex, needs}, minors},
          {{"ipopt_feasible", "Ipopt, feasible start", ipopt_source, Kind::convex, needs}, feasible},
          {{"ipopt_cone", "Ipopt, cones", ipopt_source, Kind::convex, needs}, cone}};
}

}  // namespace isostretch::baselines
