#include <isostretch/deformation/interpolation_start.hpp>

namespace isostretch::deformation {
namespace {

constexpr std::size_t most_frames = 4;

}  // namespace

ExtrapolatedStart::ExtrapolatedStart(Continuation kind, const RigidPlacement& placement)
    : kind_(kind), placement_(placement) {
  add(0, placement.first());
}

void ExtrapolatedStart::add(double t, const Vector& settled) {
  last_.insert(last_.begin(), {t, settled});
  if (last_.size() > most_frames) last_.pop_back();
}

FrameStart ExtrapolatedStart::start(double t, ShapeEnergy& energy) const {
  FrameStart best{"previous", last_.front().positions};
  if (kind_ == Continuation::previous) return best;
  double least = energy.value(best.positions);
  const auto consider = [&](const char* name, std::size_t frames, const Vector* end) {
    Vector x = continued(t, frames, end);
    const double value = energy.value(x);
    if (!(value < least)) return;
    least = value;
    best = {name + std::to_string(frames), std::move(x)};
  };
  const std::size_t all = last_.size();
  const Vector second = placement_.second_near(best.positions);
  consider("towards_second_", all, &second);
  if (all > 1) {
    consider("towards_second_", all - 1, &second);
    consider("extrapolated_", all, nullptr);
  }
  return best;
}

// Lagrange's polynomial, entry by entry.
Vector ExtrapolatedStart::continued(double t, std::size_t frames, const Vector* end) const {
  std::vector<double> times;
  std::vector<const Vector*> values;
  for (std::size_t i = 0; i < frames; ++i) {
    times.push_back(last_[i].t);
    values.push_back(&last_[i].positions);
  }
  if (end != nullptr) {
    times.push_back(1);
    values.push_back(end);
  }
  Vector x = Vector::Zero(placement_.first().size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    double weight = 1;
    for (std::size_t j = 0; j < times.size(); ++j)
      if (j != i) weight *= (t - times[j]) / (times[i] - times[j]);
    x += weight * *values[i];
  }
  return x;
}

}  // namespace isostretch::deformation
