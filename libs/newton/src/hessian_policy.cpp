#include "hessian_policy.hpp"

#include <algorithm>

namespace isostretch::newton {

using projection::Filter;
using projection::FilterOptions;

namespace {

constexpr double short_step = 0.2;

}  // namespace

FilterOptions HessianPolicy::first() {
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
  tried_ = wait_ == 0 && full_step_ ? 0.0 : strength_;
  return {Filter::clamp, options_.filter_threshold, tried_};
}

bool HessianPolicy::stronger(FilterOptions& filter) {
  if (options_.projection != Projection::adaptive || tried_ >= 1.0) return false;
  tried_ = filter.strength = tried_ < strength_ ? strength_ : 1.0;
  wait_ = options_.retry_interval;
  return true;
}

void HessianPolicy::step_taken(double step) {
  strength_ = tried_;
  full_step_ = step >= 1.0;
  wait_ = std::max(0, wait_ - 1);
  if (strength_ < 1.0 && step < short_step) {
    strength_ = 0.5 * (1.0 + strength_);
    wait_ = options_.retry_interval;
  }
}

}  // namespace isostretch::newton
