#include "hessian_policy.hpp"

#include <algorithm>
#include <cstdlib>

namespace isostretch::newton {

using projection::Filter;
using projection::FilterOptions;

projection::FilterOptions HessianPolicy::first() {
  failed_ = false;
  switch (options_.projection) {
    case Projection::none:
      return {Filter::none, 0.0, 0.0};
    case Projection::clamp:
      return {Filter::clamp, options_.filter_threshold, 1.0};
    case Projection::abs:
      return {Filter::abs, options_.filter_threshold, 1.0};
    case Projection::adaptive:
      break;
  }
  last_used_ = strength_;
  return {Filter::clamp, options_.filter_threshold, strength_};
}

bool HessianPolicy::stronger(FilterOptions& filter) {
  if (options_.projection != Projection::adaptive || filter.strength >= 1.0) return false;
  failed_ = true;
  filter.strength = 1.0;
  last_used_ = 1.0;
  return true;
}

void HessianPolicy::step_taken(double step, double) {
  if (failed_) {
    wait_ = 3;
    strength_ = 1.0;
    return;
  }
  if (wait_ > 0) --wait_;
  strength_ = (wait_ == 0 && step >= 1.0) ? 0.0 : (strength_ == 0.0 ? 0.0 : 1.0);
}

}  // namespace isostretch::newton
