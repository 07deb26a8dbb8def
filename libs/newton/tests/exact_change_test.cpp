// Terms that know by how much a step changes them, better than a difference of values does.
#include <isostretch/energies/registry.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/newton/minimize.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace isostretch;

namespace {

constexpr double huge = 1e12;

// 1e12 + scale * sum of sqrt(1 + (x - target)^2): full Newton steps overshoot further and further where
// |x - target| > 1, so that the line search has to tell a gain from a loss.
class Hill final : public newton::Term {
 public:
  Hill(Vector target, double scale, bool exact) : target_(std::move(target)), scale_(scale), exact_(exact) {}
  void add_stencil(assembly::PatternBuilder&) const override {}
  void set_pattern(const assembly::HessianPattern& pattern) override { pattern_ = &pattern; }
  newton::Evaluation value(const Vector& x) override {
    newton::Evaluation at;
    at.value = huge;
    for (Eigen::Index i = 0; i < x.size(); ++i) at.value += scale_ * std::hypot(1.0, x[i] - target_[i]);
    return at;
  }
  bool has_exact_change() const override { return exact_; }
  // sqrt(1 + b^2) - sqrt(1 + a^2) = (b - a) (b + a) / (sqrt(1 + b^2) + sqrt(1 + a^2)).
  double change(const Vector& x, const Vector& dx, double t) override {
    if (!exact_) return Term::change(x, dx, t);
    double sum = 0;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double a = x[i] - target_[i], by = t * dx[i], b = a + by;
      sum += scale_ * by * (a + b) / (std::hypot(1.0, a) + std::hypot(1.0, b));
    }
    return sum;
  }
  newton::Evaluation differentiate(const Vector& x, const projection::FilterOptions&, Vector& gradient,
                                   bool) override {
    curvature_.resize(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double a = x[i] - target_[i], root = std::hypot(1.0, a);
      gradient[i] += scale_ * a / root;
      curvature_[i] = scale_ / (root * root * root);
    }
    return value(x);
  }
  void add_hessian(double* values) const override {
    for (int node = 0; node < curvature_.size() / 2; ++node) {
      const int* positions = pattern_->positions(pattern_->block(node, node));
      for (int axis = 0; axis < 2; ++axis) values[positions[3 * axis]] += curvature_[2 * node + axis];
    }
  }

 private:
  Vector target_;
  double scale_;
  bool exact_;
  Vector curvature_;
  const assembly::HessianPattern* pattern_ = nullptr;
};

newton::Options to_gradient(double tolerance) {
  newton::Options options;
  options.scaled_gradient_tolerance = 0;
  options.gradient_tolerance = tolerance;
  return options;
}

}  // namespace

TEST_CASE("exact changes: steps below the last digit of the energy are told apart, where values cannot") {
  const int nodes = 6;
  const Vector target = Vector::LinSpaced(2 * nodes, -3.0, 3.0), start = Vector::Zero(2 * nodes);
  for (const double scale : {1e-3, 1e-6}) {
    CAPTURE(scale);
    newton::Objective plain(2, nodes), exact(2, nodes);
    plain.add<Hill>(target, scale, false);
    exact.add<Hill>(target, scale, true);
    CHECK_FALSE(plain.has_exact_changes());
    CHECK(exact.has_exact_changes());
    Vector x = start, y = start;
    const newton::Summary stalled = newton::minimize(plain, x, to_gradient(1e-12 * scale)),
                          converged = newton::minimize(exact, y, to_gradient(1e-12 * scale));
    CHECK(stalled.status == newton::Status::converged_roundoff);
    CHECK((x - target).cwiseAbs().maxCoeff() > 1);
    CHECK_MESSAGE(converged.status == newton::Status::converged_gradient, converged.full_report());
    CHECK((y - target).cwiseAbs().maxCoeff() < 1e-10);
  }
}

TEST_CASE("exact changes: beside a term that has none, whose differences count as they are") {
  const auto elements = assembly::elements_from(mesh::flat_elements(mesh::grid(4, 4)));
  const int nodes = elements.node_count;
  const Vector target = Vector::LinSpaced(2 * nodes, -3.0, 3.0);
  Vector start(2 * nodes);
  const auto vertices = mesh::grid(4, 4).vertices;
  for (int v = 0; v < nodes; ++v) start.segment<2>(2 * v) = 1.5 * vertices.row(v).head<2>();
  const auto gradient_at_end = [&](bool exact) {
    newton::Objective objective(2, nodes);
    objective.add<newton::EnergyTerm>(elements, energies::make_energy("arap"));
    objective.add<Hill>(target, 1e-2, exact);
    Vector x = start;
    return newton::minimize(objective, x, to_gradient(1e-13)).gradient_inf_norm;
  };
  CHECK(gradient_at_end(true) <= 1e-13);
  CHECK(gradient_at_end(false) > 1e-5);
}

TEST_CASE("exact changes: the default is the difference of values, and the sum is over those that know") {
  const int nodes = 3;
  const Vector target = Vector::Ones(2 * nodes), x = Vector::LinSpaced(2 * nodes, 0.0, 5.0),
               dx = Vector::LinSpaced(2 * nodes, 1.0, -1.0);
  Hill plain(target, 1e6, false), exact(target, 1e6, true);
  const double expected = exact.change(x, dx, 0.5);
  CHECK(std::abs(plain.change(x, dx, 0.5) - expected) < 1e-3);
  newton::Objective objective(2, nodes);
  objective.add<Hill>(target, 1e6, true);
  objective.add<Hill>(target, 1e6, true);
  objective.add<Hill>(target, 1e6, false);
  CHECK(objective.exact_change(x, dx, 0.5) == 2 * expected);
  CHECK(objective.value_without_exact(x).value == plain.value(x).value);
}
