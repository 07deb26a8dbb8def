#pragma once

#include <isostretch/baselines/distortion.hpp>

#include <string>
#include <vector>

namespace isostretch::baselines {

// One method for distortion energies, given a valid problem that suits it.
struct Method {
  MethodInfo info;
  std::string (*why_not_applicable)(const DistortionProblem&) =
      nullptr;  // as baselines::why_not_applicable(); null: suits all
  newton::Summary (*run)(const DistortionProblem&, Vector& x, const MethodOptions&,
                         const newton::IterationCallback&) = nullptr;
};

// Each in its own file, as many methods as it has variants.
std::vector<Method> newton_methods();
std::vector<Method> point_projection();
std::vector<Method> element_projection();
std::vector<Method> eigenvalue_methods();
std::vector<Method> slim();
std::vector<Method> killing();
std::vector<Method> quadratic_proxy_methods();
std::vector<Method> local_global_methods();
std::vector<Method> anderson_methods();
std::vector<Method> lbfgs_methods();
std::vector<Method> bcqn_methods();

}  // namespace isostretch::baselines
