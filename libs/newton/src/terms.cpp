#include <isostretch/core/error.hpp>
#include <isostretch/newton/term.hpp>

#include <cmath>
#include <string>
#include <utility>

namespace isostretch::newton {

Term::~Term() = default;
double Term::max_step(const Eigen::VectorXd&, const Eigen::VectorXd&, double limit) const {
  return limit;
}

EnergyTerm::EnergyTerm(const assembly::Elements& elements, energies::AnyEnergy energy)
    : assembler_(elements, std::move(energy)) {}

void EnergyTerm::add_to(assembly::PatternBuilder& builder) const {
  assembler_.add_to(builder);
}
void EnergyTerm::bind(const assembly::HessianPattern& pattern) {
  assembler_.bind(pattern);
}
Evaluation EnergyTerm::value(const Eigen::VectorXd& x) {
  return assembler_.value(x.data());
}

Evaluation EnergyTerm::differentiate(const Eigen::VectorXd& x, const projection::FilterOptions& filter,
                                     Eigen::VectorXd& gradient, bool hessian) {
  return assembler_.differentiate(x.data(), filter, gradient.data(), hessian);
}

void EnergyTerm::add_hessian(double* values) const {
  assembler_.add_hessian(values);
}

double EnergyTerm::max_step(const Eigen::VectorXd& x, const Eigen::VectorXd& dx, double limit) const {
  return assembler_.max_step(x.data(), dx.data(), limit);
}

SoftPinTerm::SoftPinTerm(int dim, int node_count, std::vector<SoftPin> pins)
    : dim_(dim), pins_(std::move(pins)) {
  for (std::size_t i = 0; i < pins_.size(); ++i) {
    const SoftPin& pin = pins_[i];
    const std::string name = "soft pin " + std::to_string(i);
    if (pin.node < 0 || pin.node >= node_count)
      throw Error(name + ": node " + std::to_string(pin.node) + " is not among the " +
                  std::to_string(node_count) + " there are");
    if (pin.target.size() != dim || !pin.target.allFinite())
      throw Error(name + ": target must be " + std::to_string(dim) + " finite numbers");
    if (!(pin.weight > 0) || !std::isfinite(pin.weight)) throw Error(name + ": weight must be positive");
  }
}

void SoftPinTerm::add_to(assembly::PatternBuilder&) const {}  // every node has its diagonal block
void SoftPinTerm::bind(const assembly::HessianPattern& pattern) {
  pattern_ = &pattern;
}

Evaluation SoftPinTerm::value(const Eigen::VectorXd& x) {
  Evaluation result;
  for (const SoftPin& pin : pins_)
    result.value += pin.weight * (x.segment(pin.node * dim_, dim_) - pin.target).squaredNorm();
  return result;
}

Evaluation SoftPinTerm::differentiate(const Eigen::VectorXd& x, const projection::FilterOptions&,
                                      Eigen::VectorXd& gradient, bool) {
  for (const SoftPin& pin : pins_)
    gradient.segment(pin.node * dim_, dim_) +=
        2 * pin.weight * (x.segment(pin.node * dim_, dim_) - pin.target);
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
