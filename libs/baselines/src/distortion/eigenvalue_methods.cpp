// Methods that are Newton's with other eigenvalues at every quadrature point.
#include "applicability.hpp"
#include "chen_weber_rule.hpp"
#include "composite_majorization_rules.hpp"
#include "eigenvalue_rule.hpp"
#include "mcadams_rule.hpp"
#include "method_registry.hpp"
#include "newton_driver.hpp"
#include "smith_2018_rule.hpp"
#include "stomakhin_rule.hpp"
#include "teran_rule.hpp"

#include <memory>

namespace isostretch::baselines {
namespace {

template <class Rule>
newton::Summary run(const DistortionProblem& problem, Vector& x, const MethodOptions& options,
                    const newton::IterationCallback& callback) {
  const Timer timer;
  return minimize_with(
      timer, std::make_unique<newton::EnergyTerm>(problem.elements, with_rule<Rule>(problem.energy)), problem,
      x, options, callback);
}

std::string planar_only(const DistortionProblem& problem) {
  return needs_dimension(problem, 2);
}

std::string planar_arap_only(const DistortionProblem& problem) {
  const std::string why = needs_dimension(problem, 2);
  return why.empty() ? needs_energy(problem, {"arap"}) : why;
}

std::string corotational_only(const DistortionProblem& problem) {
  return needs_energy(problem, {"arap", "corotational"});
}

std::string invertible_neo_hookean_only(const DistortionProblem& problem) {
  return needs_energy(problem, {"stable_neo_hookean", "stable_neo_hookean_log"});
}

}  // namespace

std::vector<Method> eigenvalue_methods() {
  return {
      {{"teran", "numerical, in the singular frame", "Teran et al. 2005", Family::newton},
       nullptr,
       run<TeranRule>},
      {{"stomakhin", "principal stresses", "Stomakhin et al. 2012", Family::newton},
       nullptr,
       run<StomakhinRule>},
      {{"mcadams", "clamped rotation gradient", "McAdams et al. 2011", Family::newton},
       corotational_only,
       run<McAdamsRule>},
      {{"smith_2018", "term by term", "Smith, de Goes, Kim 2018", Family::newton},
       invertible_neo_hookean_only,
       run<Smith2018Rule>},
      {{"chen_weber", "complex derivatives", "Chen, Weber 2017", Family::newton},
       planar_only,
       run<ChenWeberRule>},
      {{"composite_majorization", "composite majorization", "Shtengel et al. 2017", Family::majorization},
       planar_only,
       run<ConesRule>},
      {{"composite_majorization_singular", "composite majorization, singular values", "Shtengel et al. 2017",
        Family::majorization},
       planar_only,
       run<SingularValuesRule>},
      {{"composite_majorization_ab", "composite majorization, alpha and beta", "Shtengel et al. 2017",
        Family::majorization},
       planar_arap_only,
       run<AlphaBetaRule>},
  };
}

}  // namespace isostretch::baselines
