#include "active_set.hpp"

#include <isostretch/core/error.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

namespace isostretch::handles {
namespace {

enum class Held : std::uint8_t { no, at_zero, at_one };

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

double clip(double w) {
  return std::clamp(w, 0.0, 1.0);
}

class Minimizer {
 public:
  Minimizer(const WeightSystem& system, const std::vector<bool>& unknown, const WeightOptions& options,
            const std::string& name, std::vector<double>& w)
      : system_(system),
        unknown_(unknown),
        options_(options),
        name_(name),
        w_(w),
        held_(w.size(), Held::no) {}

  WeightReport run(const std::vector<int>& start) {
    report_.iterations = 1;
    reach_ = std::max(1, eccentricity(start) / 10);
    while (change_sets()) {
      if (reach_ == 1 && !seen_.insert(held_).second) {
        descend();
        break;
      }
      count_iteration();
      solve();
    }
    finish();
    return report_;
  }

 private:
  bool is_free(std::size_t n) const { return unknown_[n] && held_[n] == Held::no; }

  double gradient(std::size_t n) const { return product(n, w_); }
  double product(std::size_t n, const std::vector<double>& v) const {
    double sum = 0;
    for (const Entry& entry : system_.squared[n]) sum += entry.value * v[at(entry.column)];
    return sum;
  }

  // Whether the bound pushes the wrong way.
  bool wants_free(std::size_t n) const {
    const double g = gradient(n) / system_.diagonal[n], least = 1e-5 * options_.tolerance;
    return held_[n] == Held::at_zero ? g < -least : g > least;
  }

  // Layers of nodes around the start.
  int eccentricity(const std::vector<int>& start) const {
    std::vector<bool> reached(w_.size(), false);
    std::vector<int> layer = start;
    for (const int n : layer) reached[at(n)] = true;
    int layers = 0;
    for (; !layer.empty(); ++layers)
      layer = next_layer(layer, [&](std::size_t n) {
        const bool is_new = unknown_[n] && !reached[n];
        reached[n] = true;
        return is_new;
      });
    return layers;
  }

  template <class Take>
  std::vector<int> next_layer(const std::vector<int>& layer, const Take& take) const {
    std::vector<int> next;
    for (const int n : layer)
      for (const Entry& entry : system_.stiffness[at(n)])
        if (take(at(entry.column))) next.push_back(entry.column);
    return next;
  }

  // The sets that w and its gradient suggest; false when they are those there are. Only nodes beside free
  // ones have a gradient, so that one layer a time would be let go: beyond it go the next layers, as many as
  // `reach_`, which is halved when it turns out to have been too far.
  bool change_sets() {
    std::vector<int> caught_at_zero, caught_at_one, front;
    for (std::size_t n = 0; n < w_.size(); ++n) {
      if (!unknown_[n]) continue;
      if (held_[n] != Held::no) {
        if (wants_free(n)) front.push_back(static_cast<int>(n));
      } else if (w_[n] < -options_.tolerance) {
        caught_at_zero.push_back(static_cast<int>(n));
      } else if (w_[n] > 1 + options_.tolerance) {
        caught_at_one.push_back(static_cast<int>(n));
      }
    }
    const bool caught = !caught_at_zero.empty() || !caught_at_one.empty();
    if (!caught && front.empty()) return false;
    if (released_ && caught) reach_ = std::max(1, reach_ / 2);
    released_ = !front.empty();
    release(std::move(front));
    for (const int n : caught_at_zero) held_[at(n)] = Held::at_zero;
    for (const int n : caught_at_one) held_[at(n)] = Held::at_one;
    return true;
  }

  void release(std::vector<int> layer) {
    for (const int n : layer) held_[at(n)] = Held::no;
    for (int step = 1; step < reach_ && !layer.empty(); ++step)
      layer = next_layer(layer, [&](std::size_t n) {
        const bool was_held = held_[n] != Held::no;
        held_[n] = Held::no;
        return was_held;
      });
  }

  void count_iteration() {
    if (report_.iterations++ < options_.max_iterations) return;
    throw Error(name_ + ": the active set is not found within " + std::to_string(options_.max_iterations) +
                " iterations, KKT residual " + std::to_string(kkt_residual()));
  }

  void solve() {
    std::vector<bool> free(w_.size());
    for (std::size_t n = 0; n < w_.size(); ++n) {
      free[n] = is_free(n);
      if (unknown_[n] && held_[n] != Held::no) w_[n] = held_[n] == Held::at_one ? 1 : 0;
    }
    system_.free_system.solve(free, w_, 1);
    ++report_.factorizations;
  }

  // Projected Newton steps: nodes at a bound that pushes the right way are held, all others take the step to
  // the minimum without bounds, are set back to the bounds, and the energy must fall.
  void descend() {
    report_.descended = true;
    for (std::size_t n = 0; n < w_.size(); ++n)
      if (unknown_[n]) w_[n] = clip(w_[n]);
    do {
      hold_by_gradient();
      count_iteration();
    } while (projected_step());
  }

  void hold_by_gradient() {
    for (std::size_t n = 0; n < w_.size(); ++n) {
      if (!unknown_[n]) continue;
      const double g = gradient(n);
      held_[n] = w_[n] <= 0 && g >= 0 ? Held::at_zero : w_[n] >= 1 && g <= 0 ? Held::at_one : Held::no;
    }
  }

  // False when nothing moves any more beyond rounding.
  bool projected_step() {
    const std::vector<double> from = w_;
    solve();
    const std::vector<double> target = std::exchange(w_, from);
    for (double share = 1; share > 1e-12; share /= 2) {
      std::vector<double> step(w_.size(), 0.0);
      double longest = 0, slope = 0, curvature = 0;
      for (std::size_t n = 0; n < w_.size(); ++n) {
        if (!unknown_[n]) continue;
        step[n] = clip(from[n] + share * (target[n] - from[n])) - from[n];
        longest = std::max(longest, std::abs(step[n]));
      }
      if (longest <= 1e-3 * options_.tolerance) return false;
      for (std::size_t n = 0; n < w_.size(); ++n) {
        if (step[n] == 0) continue;
        slope += step[n] * gradient(n);
        curvature += step[n] * product(n, step);
      }
      if (slope + 0.5 * curvature > 1e-4 * slope) continue;
      for (std::size_t n = 0; n < w_.size(); ++n) w_[n] = from[n] + step[n];
      return true;
    }
    return false;
  }

  void finish() {
    for (std::size_t n = 0; n < w_.size(); ++n) {
      if (!unknown_[n]) continue;
      w_[n] = clip(w_[n]);
      report_.at_zero += w_[n] == 0;
      report_.at_one += w_[n] == 1;
    }
    report_.kkt_residual = kkt_residual();
  }

  double kkt_residual() const {
    double worst = 0;
    for (std::size_t n = 0; n < w_.size(); ++n)
      if (unknown_[n])
        worst = std::max(worst, std::abs(w_[n] - clip(w_[n] - gradient(n) / system_.diagonal[n])));
    return worst;
  }

  const WeightSystem& system_;
  const std::vector<bool>& unknown_;
  const WeightOptions& options_;
  const std::string& name_;
  std::vector<double>& w_;
  std::vector<Held> held_;
  std::set<std::vector<Held>> seen_;
  int reach_ = 1;
  bool released_ = false;
  WeightReport report_;
};

}  // namespace

WeightReport minimize_bounded(const WeightSystem& system, const std::vector<bool>& unknown,
                              const std::vector<int>& start, const WeightOptions& options,
                              const std::string& name, std::vector<double>& w) {
  return Minimizer(system, unknown, options, name, w).run(start);
}

}  // namespace isostretch::handles
