#include <isostretch/assembly/energy_assembler.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/energies/any_energy.hpp>
#include <isostretch/newton/solver.hpp>
#include <isostretch/parameterization/untangle.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace isostretch::parameterization {
namespace {

// chi(J) = (J + sqrt(epsilon^2 + J^2)) / 2: positive everywhere, and J itself far above zero.
double regularised(double epsilon, double J) {
  const double root = std::hypot(epsilon, J);
  return J >= 0 ? 0.5 * (J + root) : 0.5 * epsilon * epsilon / (root - J);
}

struct FoldoverFree {
  static constexpr const char* name = "foldover_free";
  double epsilon = 1;
  double area_weight = 1;

  template <int Dim, class T>
  T psi(const invariants::Invariants<Dim, T>& I) const {
    using isostretch::invariants::cbrt;
    using isostretch::invariants::select;
    using isostretch::invariants::sqrt;
    const T J = I.I3, root = sqrt(J * J + epsilon * epsilon);
    // Without cancellation on either side of zero.
    const T inverse = select(J < T(0.0), 2.0 / (epsilon * epsilon) * (root - J), 2.0 / (root + J));
    const T shape = Dim == 2 ? I.I2 * inverse : I.I2 * cbrt(inverse) * cbrt(inverse);
    return shape + area_weight * (J * J + 1.0) * inverse;
  }
};

class Untangler {
 public:
  Untangler(const assembly::Elements& elements, Vector& x, const UntangleOptions& options,
            const std::vector<int>& pinned_nodes)
      : elements_(elements),
        x_(x),
        options_(options),
        objective_(elements.dim, elements.node_count),
        term_(objective_.add<newton::EnergyTerm>(elements, FoldoverFree{epsilon_, options.area_weight})) {
    for (const int node : pinned_nodes) objective_.pin(node);
    options_.newton.max_iterations = options.iterations_per_round;
    options_.newton.gradient_tolerance = options_.newton.scaled_gradient_tolerance = 0;
    options_.newton.relative_energy_tolerance = 1e-3;
    options_.newton.time_limit = 0;
    solver_.emplace(objective_, options_.newton);
  }

  UntangleResult run(const UntangleCallback& callback) {
    measure();
    while (!result_.untangled && result_.rounds < options_.max_rounds) {
      if (!advance()) break;
      const bool told = callback && callback(result_, x_) == CallbackAction::stop;
      if (told || options_.stop.should_stop()) {
        result_.stopped = true;
        break;
      }
    }
    return result_;
  }

 private:
  // One round at this epsilon; false when it can go no further.
  bool advance() {
    term_.set_energy(FoldoverFree{epsilon_, options_.area_weight});
    const newton::Summary summary = solver_->solve(x_);
    ++result_.rounds;
    result_.iterations += summary.iterations;
    measure();
    log(LogLevel::debug, [&] {
      return "parameterization: untangling, round " + std::to_string(result_.rounds) + ": epsilon " +
             to_text(epsilon_) + ", smallest determinant " + to_text(result_.smallest_determinant) +
             " at element " + std::to_string(result_.worst_element);
    });
    if (result_.untangled) return true;
    if (summary.iterations == 0 && ++rounds_without_step_ > 10) return false;
    if (summary.iterations > 0) rounds_without_step_ = 0;
    shrink(summary);
    return epsilon_ > 0;
  }

  // So that chi at the worst element shrinks by 1 - s, s the share of the energy that was gained: a large
  // step when the minimisation went well (Garanzha et al. 2021, Eq. 5).
  void shrink(const newton::Summary& summary) {
    const double gained = 1 - summary.energy / summary.initial_energy, share = std::max(0.1, gained);
    const double J = result_.smallest_determinant;
    const double chi = (1 - std::min(share, 0.9)) * regularised(epsilon_, J);
    epsilon_ = std::min(epsilon_, 2 * std::sqrt(chi * std::max(chi - J, 0.0)));
  }

  void measure() {
    const assembly::EnergyAssembler assembler(elements_, FoldoverFree{});
    const std::vector<double> sigma = assembler.stretches(x_.data());
    const auto dim = static_cast<std::size_t>(elements_.dim);
    result_.smallest_determinant = HUGE_VAL;
    for (std::size_t point = 0; point * dim < sigma.size(); ++point) {
      double J = 1;
      for (std::size_t d = 0; d < dim; ++d) J *= sigma[point * dim + d];
      if (J < result_.smallest_determinant) {
        result_.smallest_determinant = J;
        result_.worst_element = static_cast<int>(point) / elements_.points_per_element;
      }
    }
    result_.untangled = result_.smallest_determinant > std::max(options_.min_determinant, 0.0);
  }

  const assembly::Elements& elements_;
  Vector& x_;
  UntangleOptions options_;
  // A collapse of everything to a point costs 2 / epsilon, the rest shape dim + 2 or so: it must not pay.
  double epsilon_ = 0.2;
  newton::Objective objective_;
  newton::EnergyTerm& term_;
  std::optional<newton::Solver> solver_;  // one analysis for all rounds
  UntangleResult result_;
  int rounds_without_step_ = 0;
};

}  // namespace

UntangleResult untangle(const assembly::Elements& elements, Vector& x, const UntangleOptions& options,
                        const std::vector<int>& pinned_nodes, const UntangleCallback& callback) {
  elements.validate();
  if (x.size() != elements.dim * elements.node_count || !x.allFinite())
    throw Error("untangle: the start must be " + std::to_string(elements.dim * elements.node_count) +
                " finite numbers");
  return Untangler(elements, x, options, pinned_nodes).run(callback);
}

}  // namespace isostretch::parameterization
