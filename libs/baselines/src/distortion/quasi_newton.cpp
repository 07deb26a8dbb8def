#include "quasi_newton.hpp"

#include <utility>
#include <vector>

namespace isostretch::baselines {

void SecantHistory::add(Vector s, Vector z) {
  const double curvature = z.dot(s);
  if (!(curvature > 0)) return;
  pairs_.push_back({std::move(s), std::move(z), curvature});
  if (pairs_.size() > length) pairs_.pop_front();
}

void SecantHistory::direction(const Vector& gradient, SharedPieces& pieces, Vector& direction) const {
  Vector q = -gradient;
  std::vector<double> alpha(pairs_.size());
  for (std::size_t i = pairs_.size(); i-- > 0;) {
    alpha[i] = pairs_[i].s.dot(q) / pairs_[i].curvature;
    q -= alpha[i] * pairs_[i].z;
  }
  pieces.solve(q, direction);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const double beta = pairs_[i].z.dot(direction) / pairs_[i].curvature;
    direction += (alpha[i] - beta) * pairs_[i].s;
  }
}

Step QuasiNewton::step(const Iterate& at, SharedPieces& pieces) {
  if (last_x_.size() > 0) {
    const Vector s = at.x - last_x_;
    history_.add(s, secant(s, at.gradient - last_gradient_, pieces));
  }
  Vector direction;
  history_.direction(at.gradient, pieces, direction);
  Vector corrected = direction;
  correct(at.x, corrected, pieces);
  if (at.gradient.dot(corrected) < 0) direction.swap(corrected);
  last_x_ = at.x;
  last_gradient_ = at.gradient;
  return search_step(at, direction, search_, pieces);
}

bool QuasiNewton::restart() {
  const bool any = !history_.empty();
  history_.clear();
  last_x_.resize(0);
  return any;
}

Vector QuasiNewton::secant(const Vector&, Vector y, SharedPieces&) {
  return y;
}

void QuasiNewton::correct(const Vector&, Vector&, SharedPieces&) {}

}  // namespace isostretch::baselines
