#include <isostretch/core/error.hpp>
#include <isostretch/sdp_penalty/options.hpp>

namespace isostretch::sdp_penalty {

void Options::validate() const {
  check_ranges(*this);
  if (penalty.factor != 0 && penalty.factor <= 1) throw OptionError("penalty.factor", "must be above 1");
  if (augmented_lagrangian.last < augmented_lagrangian.first)
    throw OptionError("augmented_lagrangian.last", "must not be below first");
}

std::string_view method_name(Method method) noexcept {
  return name_of(choice_names(method), method);
}

std::string_view penalty_name(Penalty penalty) noexcept {
  return name_of(choice_names(penalty), penalty);
}

Method method_from_name(std::string_view name) {
  return choice_from_name(choice_names(Method{}), name, "method");
}

Penalty penalty_from_name(std::string_view name) {
  return choice_from_name(choice_names(Penalty{}), name, "penalty");
}

const std::vector<Method>& all_methods() {
  static const std::vector<Method> methods{Method::interior_point, Method::augmented_lagrangian,
                                           Method::penalty,        Method::spectral_sdp,
                                           Method::pennon,         Method::unconstrained};
  return methods;
}

const std::vector<Penalty>& all_penalties() {
  static const std::vector<Penalty> penalties{Penalty::quadratic, Penalty::cubic, Penalty::spline};
  return penalties;
}

}  // namespace isostretch::sdp_penalty
