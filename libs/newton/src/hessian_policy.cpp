#include "hessian_policy.hpp"

#include <algorithm>

namespace isostretch::newton {

using projection::Filter;
using projection::FilterOptions;

namespace {

constexpr double short_step = 0.2;

// adaptive, between clamping and absolute values: gains below and above these shares of the promised one show
// a model too soft and too stiff; and what is left of the way to the absolute value in the second case.
constexpr double soft_fit = 0.1, stiff_fit = 1.25, relaxation = 0.7;

// adaptive, without a barrier: a step that gained more than this share met curvature far below that of the
// filtered model, and the exact Hessian hardly ever factorises then. With a barrier such gains are the rule.
constexpr double hopeless_fit = 1.2;

// trust_region: shares from which on the model is taken for good, and for usable.
constexpr double good_fit = 0.75, usable_fit = 0.01;

// progressive: share of the largest residual after a step, what it is multiplied by when the factorization
// fails and after it has succeeded, and below which share every element is filtered.
constexpr double largest_share = 0.5, share_after_failure = 0.1, share_after_success = 4,
                 smallest_share = 1e-4;

}  // namespace

FilterOptions HessianPolicy::full(Filter filter) const {
  return {filter, options_.filter_threshold, 1.0, nullptr};
}

FilterOptions HessianPolicy::at(double weight) {
  tried_ = weight;
  if (weight == exact) return {Filter::none, 0.0, 0.0, nullptr};
  if (weight <= clamped) return {Filter::clamp, options_.filter_threshold, weight / clamped, nullptr};
  return {Filter::bounded_abs, options_.filter_threshold, (weight - clamped) / (absolute - clamped), nullptr};
}

FilterOptions HessianPolicy::first() {
  switch (options_.projection) {
    case Projection::none:
      return {Filter::none, 0.0, 0.0, nullptr};
    case Projection::clamp:
    case Projection::progressive:
      return full(Filter::clamp);
    case Projection::abs:
      return full(Filter::abs);
    case Projection::trust_region:
      if (model_fit_ > good_fit) return {Filter::none, 0.0, 0.0, nullptr};
      return full(model_fit_ > usable_fit ? Filter::clamp : Filter::abs);
    case Projection::adaptive:
      break;
  }
  const bool hopeless = most_ == absolute && model_fit_ > hopeless_fit;
  return at(wait_ == 0 && full_step_ && !hopeless ? exact : weight_);
}

bool HessianPolicy::stronger(FilterOptions& filter) {
  switch (options_.projection) {
    case Projection::trust_region:
      if (filter.filter != Filter::none) return false;
      filter = full(Filter::clamp);
      return true;
    case Projection::progressive:
      if (share_ == 0) return false;
      share_ *= share_after_failure;
      if (share_ < smallest_share) share_ = 0;
      filter.nodes = nullptr;
      return true;
    case Projection::adaptive:
      if (tried_ >= clamped) return false;
      filter = at(tried_ < weight_ ? weight_ : fallback_weight_);
      wait_ = options_.retry_interval;
      return true;
    case Projection::none:
    case Projection::clamp:
    case Projection::abs:
      break;
  }
  return false;
}

void HessianPolicy::step_taken(double step, double model_fit) {
  model_fit_ = model_fit;
  share_ = share_ == 0 ? largest_share : std::min(largest_share, share_after_success * share_);
  if (options_.projection == Projection::adaptive) adapt(step, model_fit);
}

void HessianPolicy::adapt(double step, double model_fit) {
  weight_ = tried_;
  full_step_ = step >= 1.0;
  wait_ = std::max(0, wait_ - 1);
  if (weight_ >= clamped) {
    if (model_fit < soft_fit) fallback_weight_ = most_;
    if (model_fit > stiff_fit) fallback_weight_ = clamped + relaxation * (fallback_weight_ - clamped);
    weight_ = fallback_weight_;
  } else if (step < short_step) {
    weight_ = 0.5 * (clamped + weight_);
    wait_ = options_.retry_interval;
  }
}

void HessianPolicy::choose_nodes(const Vector& gradient, int dim, FilterOptions& filter) {
  const Eigen::Index nodes = gradient.size() / dim;
  const double limit = share_ * gradient.cwiseAbs().maxCoeff();
  nodes_.resize(static_cast<std::size_t>(nodes));
  for (Eigen::Index i = 0; i < nodes; ++i)
    nodes_[static_cast<std::size_t>(i)] = gradient.segment(i * dim, dim).cwiseAbs().maxCoeff() >= limit;
  filter.nodes = nodes_.data();
}

}  // namespace isostretch::newton
