#include <isostretch/core/error.hpp>
#include <isostretch/sdp_penalty/options.hpp>

#include <cmath>
#include <string>

namespace isostretch::sdp_penalty {
namespace {

template <class Choice, class Name>
Choice from_name(std::string_view text, const std::vector<Choice>& all, const Name& name, const char* what) {
  std::string names;
  for (const Choice choice : all) {
    if (name(choice) == text) return choice;
    names.append(names.empty() ? "" : ", ").append(name(choice));
  }
  throw Error("no " + std::string(what) + " '" + std::string(text) + "'; there are " + names);
}

void require(bool condition, const char* text) {
  if (!condition) throw Error(std::string("inversion-free solver: ") + text);
}

void validate_path(const PenaltyOptions& options) {
  require(options.epsilon >= 0 && std::isfinite(options.epsilon), "penalty.epsilon must not be negative");
  require(options.first >= 0 && std::isfinite(options.first), "penalty.first must not be negative");
  require(options.factor == 0 || (options.factor > 1 && std::isfinite(options.factor)),
          "penalty.factor must be above 1");
  require(options.last >= 0 && std::isfinite(options.last), "penalty.last must not be negative");
  require(options.level_iterations > 0, "penalty.level_iterations must be positive");
}

void validate_multipliers(const AugmentedLagrangianOptions& options) {
  require(options.first > 0, "augmented_lagrangian.first must be positive");
  require(options.factor > 1 && std::isfinite(options.factor), "augmented_lagrangian.factor must be above 1");
  require(options.last >= options.first && std::isfinite(options.last),
          "augmented_lagrangian.last must not be below first");
  require(options.epsilon >= 0 && std::isfinite(options.epsilon),
          "augmented_lagrangian.epsilon must not be negative");
}

}  // namespace

void Options::validate() const {
  require(gap_tolerance > 0 && gap_tolerance < 1, "gap_tolerance must be between 0 and 1");
  require(max_iterations >= 0, "max_iterations must not be negative");
  require(interior_point.step_fraction > 0 && interior_point.step_fraction < 1,
          "interior_point.step_fraction must be between 0 and 1");
  require(interior_point.least_eigenvalue > 0 && std::isfinite(interior_point.least_eigenvalue),
          "interior_point.least_eigenvalue must be positive");
  require(interior_point.centrality_corrections >= 0,
          "interior_point.centrality_corrections must not be negative");
  validate_path(penalty);
  validate_multipliers(augmented_lagrangian);
}

std::string_view method_name(Method method) noexcept {
  switch (method) {
    case Method::interior_point:
      return "interior_point";
    case Method::augmented_lagrangian:
      return "augmented_lagrangian";
    case Method::penalty:
      return "penalty";
    case Method::spectral_sdp:
      return "spectral_sdp";
    case Method::pennon:
      return "pennon";
    case Method::skinning:
      return "skinning";
  }
  return "?";
}

std::string_view penalty_name(Penalty penalty) noexcept {
  switch (penalty) {
    case Penalty::quadratic:
      return "quadratic";
    case Penalty::cubic:
      return "cubic";
    case Penalty::spline:
      return "spline";
  }
  return "?";
}

Method method_from_name(std::string_view name) {
  return from_name(name, all_methods(), method_name, "method");
}

Penalty penalty_from_name(std::string_view name) {
  return from_name(name, all_penalties(), penalty_name, "penalty");
}

const std::vector<Method>& all_methods() {
  static const std::vector<Method> methods{Method::interior_point, Method::augmented_lagrangian,
                                           Method::penalty,        Method::spectral_sdp,
                                           Method::pennon,         Method::skinning};
  return methods;
}

const std::vector<Penalty>& all_penalties() {
  static const std::vector<Penalty> penalties{Penalty::quadratic, Penalty::cubic, Penalty::spline};
  return penalties;
}

}  // namespace isostretch::sdp_penalty
