// Solvers of nonlinear programs: Ipopt and NLopt, in the table also where this is built without them.
#include "registry.hpp"

#if defined(ISOSTRETCH_WITH_IPOPT)
#include "ipopt_solvers.hpp"
#endif
#if defined(ISOSTRETCH_WITH_NLOPT)
#include "nlopt_solvers.hpp"
#endif

namespace isostretch::baselines {

std::vector<Entry> ipopt_solvers() {
#if defined(ISOSTRETCH_WITH_IPOPT)
  const std::string needs;
  const Run minors = run_ipopt, feasible = run_ipopt_feasible, cone = run_ipopt_cone;
#else
  const std::string needs = "isostretch was built without Ipopt (Debian: coinor-libipopt-dev)";
  const Run minors = nullptr, feasible = nullptr, cone = nullptr;
#endif
  constexpr std::string_view source = "Waechter, Biegler 2006: filter line search, interior point";
  return {{{"ipopt", "Ipopt", source, Kind::convex, needs}, minors},
          {{"ipopt_feasible", "Ipopt, feasible start", source, Kind::convex, needs}, feasible},
          {{"ipopt_cone", "Ipopt, cones", source, Kind::convex, needs}, cone}};
}

std::vector<Entry> nlopt_solvers() {
#if defined(ISOSTRETCH_WITH_NLOPT)
  const std::string needs;
  const Run mma = run_nlopt_mma, ccsaq = run_nlopt_ccsaq, slsqp = run_nlopt_slsqp, auglag = run_nlopt_auglag;
#else
  const std::string needs = "isostretch was built without NLopt (Debian: libnlopt-dev)";
  const Run mma = nullptr, ccsaq = nullptr, slsqp = nullptr, auglag = nullptr;
#endif
  return {
      {{"nlopt_mma", "NLopt MMA", "Svanberg 2002", Kind::convex, needs}, mma},
      {{"nlopt_ccsaq", "NLopt CCSA", "Svanberg 2002: quadratic approximations", Kind::convex, needs}, ccsaq},
      {{"nlopt_slsqp", "NLopt SLSQP", "Kraft 1994", Kind::convex, needs}, slsqp},
      {{"nlopt_auglag", "NLopt AUGLAG", "Birgin, Martinez 2008; inside, L-BFGS of Luksan", Kind::convex,
        needs},
       auglag}};
}

}  // namespace isostretch::baselines
