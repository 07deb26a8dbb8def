#include <isostretch/core/error.hpp>
#include <isostretch/newton/term.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

namespace isostretch::newton {

Term::~Term() = default;
double Term::max_step(const Vector&, const Vector&, double limit) const {
  return limit;
}
bool Term::has_barrier() const {
  return false;
}
void Term::require_fits(int, int) const {}
void Term::begin_solve(const Vector&) {}
void Term::accepted(const Vector&) {}
bool Term::has_moving_stencil() const {
  return false;
}
int Term::stencil_version() const {
  return 0;
}
bool Term::has_exact_change() const {
  return false;
}
double Term::change(const Vector& x, const Vector& dx, double t) {
  const Vector there = x + t * dx;
  return value(there).value - value(x).value;
}
int Term::element_not_finite() const {
  return -1;
}

void require_fitting(const char* term, int dim, int node_count, int objective_dim, int objective_node_count) {
  if (dim != objective_dim)
    throw Error(std::string(term) + " in " + std::to_string(dim) + "D in an objective in " +
                std::to_string(objective_dim) + "D");
  if (node_count > objective_node_count)
    throw Error(std::string(term) + " of " + std::to_string(node_count) + " nodes in an objective of " +
                std::to_string(objective_node_count));
}

EnergyTerm::EnergyTerm(const assembly::Elements& elements, energies::AnyEnergy energy)
    : assembler_(elements, std::move(energy)) {}

void EnergyTerm::set_scale(double scale) {
  left_out_ = scale == 0;
  if (!left_out_) assembler_.set_scale(scale);
}

void EnergyTerm::require_fits(int dim, int node_count) const {
  require_fitting("an energy term", assembler_.dim(), assembler_.node_count(), dim, node_count);
}
int EnergyTerm::element_not_finite() const {
  return left_out_ ? -1 : assembler_.element_not_finite();
}

void EnergyTerm::add_stencil(assembly::PatternBuilder& builder) const {
  assembler_.add_stencil(builder);
}
void EnergyTerm::set_pattern(const assembly::HessianPattern& pattern) {
  assembler_.set_pattern(pattern);
}
Evaluation EnergyTerm::value(const Vector& x) {
  return left_out_ ? Evaluation{} : assembler_.value(x.data());
}

Evaluation EnergyTerm::differentiate(const Vector& x, const projection::FilterOptions& filter,
                                     Vector& gradient, bool hessian) {
  if (left_out_) return {};
  return assembler_.differentiate(x.data(), filter, gradient.data(), hessian);
}

void EnergyTerm::add_hessian(double* values) const {
  if (!left_out_) assembler_.add_hessian(values);
}

double EnergyTerm::max_step(const Vector& x, const Vector& dx, double limit) const {
  return left_out_ ? limit : assembler_.max_step(x.data(), dx.data(), limit);
}

SoftPinTerm::SoftPinTerm(int dim, int node_count, std::vector<SoftPin> pins)
    : dim_(dim), node_count_(node_count), pins_(std::move(pins)) {
  for (std::size_t i = 0; i < pins_.size(); ++i) {
    const SoftPin& pin = pins_[i];
    const std::string name = "soft pin " + std::to_string(i);
    if (pin.node < 0 || pin.node >= node_count)
      throw Error(name + ": node " + std::to_string(pin.node) + " is not among the " +
                  std::to_string(node_count) + " there are");
    const bool finite =
        std::all_of(pin.target.begin(), pin.target.end(), [](double t) { return std::isfinite(t); });
    if (std::ssize(pin.target) != dim || !finite)
      throw Error(name + ": target must be " + std::to_string(dim) + " finite numbers");
    if (!(pin.weight > 0) || !std::isfinite(pin.weight)) throw Error(name + ": weight must be positive");
  }
}

void SoftPinTerm::require_fits(int dim, int node_count) const {
  require_fitting("a term of soft pins", dim_, node_count_, dim, node_count);
}
void SoftPinTerm::add_stencil(assembly::PatternBuilder&) const {}  // every node has its diagonal block
void SoftPinTerm::set_pattern(const assembly::HessianPattern& pattern) {
  pattern_ = &pattern;
}

Evaluation SoftPinTerm::value(const Vector& x) {
  Evaluation result;
  for (const SoftPin& pin : pins_)
    for (int axis = 0; axis < dim_; ++axis) {
      const double distance = x[pin.node * dim_ + axis] - pin.target[static_cast<std::size_t>(axis)];
      result.value += pin.weight * distance * distance;
    }
  return result;
}

Evaluation SoftPinTerm::differentiate(const Vector& x, const projection::FilterOptions&, Vector& gradient,
                                      bool) {
  for (const SoftPin& pin : pins_)
    for (int axis = 0; axis < dim_; ++axis) {
      const int dof = pin.node * dim_ + axis;
      gradient[dof] += 2 * pin.weight * (x[dof] - pin.target[static_cast<std::size_t>(axis)]);
    }
  return value(x);
}

void SoftPinTerm::add_hessian(double* values) const {
  for (const SoftPin& pin : pins_) {
    const int* positions = pattern_->positions(pattern_->block(pin.node, pin.node));
    for (int d = 0; d < dim_; ++d)
      if (positions[d * (dim_ + 1)] >= 0) values[positions[d * (dim_ + 1)]] += 2 * pin.weight;
  }
}

}  // namespace isostretch::newton
