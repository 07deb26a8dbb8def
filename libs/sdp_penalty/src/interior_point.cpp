#include "cone.hpp"
#include "methods.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace isostretch::sdp_penalty {
namespace {

// What the slacks are kept above besides the margin, so that rounding of S leaves x feasible; it costs the
// sum of the multipliers' traces times this, some 1e-10 of the energy.
constexpr double interior_slack = 1e-10;

// Multipliers have the size of the weights, and start there times the slacks' inverses. Where no eigenvalue
// is far below the margin they are smaller, and a lower start saves an iteration or two; elsewhere it costs
// more than that.
constexpr double not_far = 0.25, lower_start = 0.3;

class InteriorPoint {
 public:
  InteriorPoint(Workspace& work, const Options& options, Progress& progress, Vector& x)
      : work_(work), system_(work.system), options_(options), progress_(progress), x_(x) {
    const double least = options_.interior_point.least_eigenvalue;
    const std::vector<double>& weights = system_.problem().weights;
    weight_ = std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
    const Constrained at_start = system_.constrained(x_);
    const double margin = system_.problem().margin;
    const bool is_mild = progress_.last().min_eigenvalue > margin - not_far;
    const double complementarity = weight_ * (is_mild ? lower_start : 1.0);
    cones_.emplace_back(system_.dim());
    cones_[0].start(at_start.orientation, margin + interior_slack, least, complementarity);
    if (system_.problem().bounds_stretch()) {
      cones_.emplace_back(2 * system_.dim());
      cones_[1].start(at_start.stretch, interior_slack, least, complementarity);
    }
  }

  void run() {
    while (!progress_.ended()) iterate();
  }

 private:
  void iterate() {
    if (progress_.give_up_at_limit(x_, multipliers(&Cone::multipliers))) return;
    if (multipliers_exploded() && progress_.give_up_contradicted(x_, multipliers(&Cone::multipliers))) return;
    for (Cone& cone : cones_)
      if (!cone.scale())
        return give_up(Status::failed, "rounding has taken slacks or multipliers to the boundary");
    if (!factorize()) return;
    // Predictor: all the way, no centring.
    const double mu = mean_complementarity();
    for (Cone& cone : cones_) cone.set_target(0, false);
    solve_direction();
    const double share = 1 - longest_step(1), centre = share * share * share * mu;  // Mehrotra's
    for (Cone& cone : cones_) cone.set_target(centre, true);
    solve_direction();
    advance(fraction() * lengthened(centre));
  }

  double fraction() const { return options_.interior_point.step_fraction; }

  // The longest step along the direction, after corrections that lengthen it (Gondzio 1996): each costs a
  // solve with the factor there is, and is dropped when it does not pay.
  double lengthened(double centre) {
    double step = longest_step(1 / fraction());
    for (int i = 0; i < options_.interior_point.centrality_corrections && fraction() * step < 0.98; ++i) {
      const Vector before = dx_;
      for (Cone& cone : cones_) cone.keep_direction();
      for (Cone& cone : cones_) cone.recentre(std::min(1.0, 1.3 * step + 0.1), centre);
      solve_direction();
      const double longer = longest_step(1 / fraction());
      if (longer < 1.05 * step) {
        dx_ = before;
        for (Cone& cone : cones_) cone.restore_direction();
        break;
      }
      step = longer;
    }
    return step;
  }

  // Beyond what any problem that has strictly feasible positions was seen to need.
  bool multipliers_exploded() const {
    constexpr double much = 1e7;
    const Blocks& Y = cones_[0].multipliers();
    return std::any_of(Y.begin(), Y.end(),
                       [&](double entry) { return !(std::abs(entry) <= much * weight_); });
  }

  bool factorize() {
    system_.assemble_normal_equations(cones_[0].weight(), work_.matrix);
    if (cones_.size() > 1) system_.add_stretch_weighted(cones_[1].weight(), work_.matrix);
    const sparse::FactorResult result = work_.factorize();
    progress_.count_solve();
    if (!result) give_up(Status::failed, result.message);
    return static_cast<bool>(result);
  }

  void solve_direction() {
    Vector gradient = progress_.gradient();
    subtract_adjoint(system_, multipliers(&Cone::dual_residual), gradient);
    dx_ = work_.direction(gradient).dx;
    const Constrained change = system_.change_of_constrained(dx_);
    cones_[0].set_direction(change.orientation);
    if (cones_.size() > 1) cones_[1].set_direction(change.stretch);
  }

  double longest_step(double limit) const {
    for (const Cone& cone : cones_) limit = cone.longest_step(limit);
    return limit;
  }

  double mean_complementarity() const {
    double sum = 0;
    std::size_t count = 0;
    for (const Cone& cone : cones_) {
      sum += cone.complementarity();
      count += cone.eigenvalues();
    }
    return sum / static_cast<double>(count);
  }

  void advance(double step) {
    x_ += step * dx_;
    Constrained constrained = system_.constrained(x_);
    Iteration row;
    for (Cone& cone : cones_) cone.advance(step);
    row.step = step;
    row.complementarity = mean_complementarity();
    progress_.count_iteration();
    progress_.record(row, x_, constrained, multipliers(&Cone::multipliers));
    cones_[0].update(std::move(constrained.orientation));
    if (cones_.size() > 1) cones_[1].update(std::move(constrained.stretch));
  }

  template <class Of>
  Constrained multipliers(Of of) const {
    return {(cones_[0].*of)(), cones_.size() > 1 ? (cones_[1].*of)() : Blocks()};
  }

  void give_up(Status status, const std::string& reason) {
    progress_.give_up(status, reason, x_, multipliers(&Cone::multipliers));
  }

  Workspace& work_;
  System& system_;
  const Options& options_;
  Progress& progress_;
  Vector& x_;
  std::vector<Cone> cones_;  // orientation, and stretch where it is bounded
  Vector dx_;
  double weight_ = 1;  // mean of the elements'
};

}  // namespace

void interior_point(Workspace& work, const Options& options, Progress& progress, Vector& x) {
  InteriorPoint(work, options, progress, x).run();
}

}  // namespace isostretch::sdp_penalty
