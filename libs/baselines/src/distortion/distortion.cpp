
#include "method_registry.hpp"

#include <isostretch/baselines/distortion.hpp>
#include <isostretch/core/error.hpp>

#include <cmath>
#include <utility>

namespace isostretch::baselines {
namespace {

std::vector<Method> registry() {
  std::vector<Method> all;
  for (const auto& family :
       {newton_methods, point_projection, element_projection, eigenvalue_methods, slim, killing,
        quadratic_proxy_methods, local_global_methods, anderson_methods, lbfgs_methods, bcqn_methods})
    for (Method& method : family()) all.push_back(std::move(method));
  return all;
}

Method method_named(std::string_view name) {
  std::string names;
  for (Method& method : registry()) {
    if (method.info.name == name) return std::move(method);
    names += (names.empty() ? "" : ", ") + std::string(method.info.name);
  }
  throw Error("there is no method '" + std::string(name) + "', there are: " + names);
}

std::string why_method_not_applicable(const Method& method, const DistortionProblem& problem) {
  return method.why_not_applicable ? method.why_not_applicable(problem) : std::string();
}

}  // namespace

std::string_view family_name(Family family) noexcept {
  switch (family) {
    case Family::own:
      return "own";
    case Family::newton:
      return "newton";
    case Family::majorization:
      return "majorization";
    case Family::constant_metric:
      return "constant_metric";
  }
  return "";
}

void DistortionProblem::validate() const {
  elements.validate();
  if (!energy.supports(elements.dim))
    throw Error("energy '" + energy.name() + "' does not exist in " + std::to_string(elements.dim) + "D");
  for (std::size_t i = 0; i < pinned.size(); ++i)
    if (pinned[i] < 0 || pinned[i] >= elements.node_count)
      throw Error("pin " + std::to_string(i) + ": node " + std::to_string(pinned[i]) + " is not among the " +
                  std::to_string(elements.node_count) + " there are");
}

void MethodOptions::validate() const {
  const auto require = [](bool condition, const char* text) {
    if (!condition) throw Error(std::string("method options: ") + text);
  };
  require(gradient_tolerance >= 0 && std::isfinite(gradient_tolerance),
          "gradient_tolerance must not be negative");
  require(max_iterations >= 0, "max_iterations must not be negative");
  require(time_limit >= 0 && std::isfinite(time_limit), "time_limit must not be negative");
}

std::vector<MethodInfo> methods() {
  std::vector<MethodInfo> infos;
  for (const Method& method : registry()) infos.push_back(method.info);
  return infos;
}

std::string why_not_applicable(std::string_view method, const DistortionProblem& problem) {
  problem.validate();
  return why_method_not_applicable(method_named(method), problem);
}

newton::Summary minimize(std::string_view name, const DistortionProblem& problem, Vector& x,
                         const MethodOptions& options, const newton::IterationCallback& callback) {
  const Method method = method_named(name);
  options.validate();
  problem.validate();
  const Eigen::Index size = problem.elements.dim * problem.elements.node_count;
  if (x.size() != size)
    throw Error("the start has " + std::to_string(x.size()) + " entries, the elements need " +
                std::to_string(size));
  if (const std::string why = why_method_not_applicable(method, problem); !why.empty())
    throw Error("'" + std::string(name) + "' does not suit the problem: " + why);
  return method.run(problem, x, options, callback);
}

}  // namespace isostretch::baselines
