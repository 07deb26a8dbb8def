#include "bounded_minimum.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/index.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace isostretch::handles {
namespace {

// Sweeps, there and back, before every system; one of 20 000 nodes in space takes as long as 150 of them.
constexpr int sweeps = 40;

enum class Held : std::uint8_t { no, at_zero, at_one };

double clip(double w) {
  return std::clamp(w, 0.0, 1.0);
}

Held bound_of(double w) {
  return w <= 0 ? Held::at_zero : w >= 1 ? Held::at_one : Held::no;
}

// Sweeps find out, node by node, which nodes the bounds hold, but hardly move what is smooth; a system with
// those nodes held takes it to where it belongs. Neither raises the energy, so that sets cannot come back for
// ever.
class Minimizer {
 public:
  Minimizer(const WeightSystem& system, const std::vector<int>& unknown, const WeightOptions& options,
            const std::string& name, std::vector<double>& w)
      : system_(system),
        unknown_(unknown),
        options_(options),
        name_(name),
        w_(w),
        held_(w.size(), Held::no) {}

  WeightReport run() {
    report_.iterations = 1;
    bool done = within_bounds();
    while (!done) {
      count_iteration();
      relax();
      hold();
      done = step();
    }
    finish();
    return report_;
  }

 private:
  double scaled_gradient(int n) const { return system_.relaxation.scaled_product(n, w_); }

  bool within_bounds() const {
    return std::all_of(unknown_.begin(), unknown_.end(), [&](int n) {
      return w_[at(n)] >= -options_.tolerance && w_[at(n)] <= 1 + options_.tolerance;
    });
  }

  void count_iteration() {
    if (report_.iterations++ < options_.max_iterations) return;
    throw Error(name_ + ": the minimum is not found within " + std::to_string(options_.max_iterations) +
                " iterations, KKT residual " + std::to_string(kkt_residual()));
  }

  void relax() {
    for (const int n : unknown_) w_[at(n)] = clip(w_[at(n)]);
    for (int sweep = 0; sweep < sweeps; ++sweep) system_.relaxation.relax(unknown_, w_);
  }

  // The bound that a node is at and that its gradient pushes it against.
  void hold() {
    for (const int n : unknown_) {
      const Held bound = bound_of(w_[at(n)]);
      held_[at(n)] = wants_free(n, bound) ? Held::no : bound;
    }
  }

  bool wants_free(int n, Held bound) const {
    if (bound == Held::no) return false;
    const double g = scaled_gradient(n), least = 1e-5 * options_.tolerance;
    return bound == Held::at_zero ? g < -least : g > least;
  }

  // To the minimum with the nodes held, or as far towards it as bounds and energy allow. Whether that is the
  // end: no bound holds a node the wrong way, or nothing moves any more beyond rounding.
  bool step() {
    const std::vector<double> from = w_;
    solve();
    return (within_bounds() && none_wants_free()) || !projected_step(from, w_);
  }

  bool none_wants_free() const {
    return std::none_of(unknown_.begin(), unknown_.end(), [&](int n) { return wants_free(n, held_[at(n)]); });
  }

  double least_move() const { return 1e-3 * options_.tolerance; }

  double largest_difference(const std::vector<double>& from) const {
    double largest = 0;
    for (const int n : unknown_) largest = std::max(largest, std::abs(w_[at(n)] - from[at(n)]));
    return largest;
  }

  void solve() {
    std::vector<bool> free(w_.size(), false);
    for (const int n : unknown_) free[at(n)] = held_[at(n)] == Held::no;
    system_.free_system.solve(free, w_, 1);
    ++report_.factorizations;
  }

  // Of steps towards the target, halved again and again and set back to the bounds, the first that makes the
  // energy fall. False when there is none. The target is a copy, for w changes.
  // NOLINTNEXTLINE(performance-unnecessary-value-param)
  bool projected_step(const std::vector<double>& from, const std::vector<double> target) {
    std::vector<double> moved(w_.size(), 0.0);
    for (double share = 1; share > 1e-12; share /= 2) {
      for (const int n : unknown_) w_[at(n)] = clip(from[at(n)] + share * (target[at(n)] - from[at(n)]));
      if (largest_difference(from) <= least_move()) return false;
      for (const int n : unknown_) moved[at(n)] = w_[at(n)] - from[at(n)];
      if (falls(from, moved)) return true;
      report_.descended = true;
    }
    return false;
  }

  // Whether the energy falls by a share of what the slope promises (Bertsekas 1982).
  bool falls(const std::vector<double>& from, const std::vector<double>& moved) const {
    double slope = 0, curvature = 0;
    for (const int n : unknown_) {
      if (moved[at(n)] == 0) continue;
      slope += moved[at(n)] * system_.relaxation.product(n, from);
      curvature += moved[at(n)] * system_.relaxation.product(n, moved);
    }
    return slope + 0.5 * curvature <= 1e-4 * slope;
  }

  void finish() {
    for (const int n : unknown_) {
      w_[at(n)] = clip(w_[at(n)]);
      report_.at_zero += w_[at(n)] == 0;
      report_.at_one += w_[at(n)] == 1;
    }
    report_.kkt_residual = kkt_residual();
  }

  double kkt_residual() const {
    double worst = 0;
    for (const int n : unknown_)
      worst = std::max(worst, std::abs(w_[at(n)] - clip(w_[at(n)] - scaled_gradient(n))));
    return worst;
  }

  const WeightSystem& system_;
  const std::vector<int>& unknown_;
  const WeightOptions& options_;
  const std::string& name_;
  std::vector<double>& w_;
  std::vector<Held> held_;
  WeightReport report_;
};

}  // namespace

WeightReport minimize_bounded(const WeightSystem& system, const std::vector<int>& unknown,
                              const WeightOptions& options, const std::string& name, std::vector<double>& w) {
  return Minimizer(system, unknown, options, name, w).run();
}

}  // namespace isostretch::handles
