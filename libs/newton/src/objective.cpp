#include "equality_constraints.hpp"
#include "moving_pattern.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/newton/objective.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>

namespace isostretch::newton {

Objective::Objective(int dim, int node_count) : dim_(dim), node_count_(node_count) {
  if (dim != 2 && dim != 3) throw Error("objective of dim " + std::to_string(dim) + ": dim is 2 or 3");
  if (node_count < 1 || node_count > std::numeric_limits<int>::max() / dim)
    throw Error("objective of " + std::to_string(node_count) + " nodes in " + std::to_string(dim) + "D");
  pinned_.assign(static_cast<std::size_t>(dofs()), false);
}

Objective::~Objective() = default;
Objective::Objective(Objective&&) noexcept = default;
Objective& Objective::operator=(Objective&&) noexcept = default;

void Objective::add_term(std::unique_ptr<Term> term) {
  if (!term) throw Error("objective: a term that is null");
  term->require_fits(dim_, node_count_);
  terms_.push_back(std::move(term));
  changed();
}

void Objective::remove(const Term& term) {
  const auto found =
      std::find_if(terms_.begin(), terms_.end(), [&](const auto& own) { return own.get() == &term; });
  if (found == terms_.end())
    throw Error(ErrorKind::misuse, "objective: the term to remove is none of its terms");
  terms_.erase(found);
  changed();
}

void Objective::begin_solve(const Vector& x) {
  for (const auto& term : terms_) term->begin_solve(x);
}

void Objective::accepted(const Vector& x) {
  for (const auto& term : terms_) term->accepted(x);
}

void Objective::changed() {
  pattern_.reset();
  ++version_;
}

void Objective::require_node(int node) const {
  if (node < 0 || node >= node_count_)
    throw Error("cannot pin node " + std::to_string(node) + ": there are " + std::to_string(node_count_));
}

void Objective::pin(int node) {
  for (int axis = 0; axis < dim_; ++axis) pin(node, axis);
}

void Objective::pin(int node, int axis) {
  require_node(node);
  if (axis < 0 || axis >= dim_)
    throw Error("cannot pin axis " + std::to_string(axis) + " of node " + std::to_string(node));
  pinned_[static_cast<std::size_t>(node) * static_cast<std::size_t>(dim_) + static_cast<std::size_t>(axis)] =
      true;
  changed();
}

int Objective::representative(int dof) const {
  while (!equal_to_.empty() && equal_to_[static_cast<std::size_t>(dof)] != dof)
    dof = equal_to_[static_cast<std::size_t>(dof)];
  return dof;
}

void Objective::add_equality(int node, int other, int axis) {
  for (const int n : {node, other})
    if (n < 0 || n >= node_count_ || axis < 0 || axis >= dim_)
      throw Error("cannot equate axis " + std::to_string(axis) + " of node " + std::to_string(n));
  if (equal_to_.empty()) {
    equal_to_.resize(static_cast<std::size_t>(dofs()));
    std::iota(equal_to_.begin(), equal_to_.end(), 0);
  }
  const int a = representative(node * dim_ + axis), b = representative(other * dim_ + axis);
  equal_to_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  changed();
}

void Objective::require_equalities(const Vector& x) const {
  for (int dof = 0; dof < static_cast<int>(equal_to_.size()); ++dof)
    if (x[dof] != x[representative(dof)])
      throw Error(
          "nodes " + std::to_string(representative(dof) / dim_) + " and " + std::to_string(dof / dim_) +
          " are to be equal but start with different coordinates along axis " + std::to_string(dof % dim_));
}

bool Objective::has_pins() const {
  return std::find(pinned_.begin(), pinned_.end(), true) != pinned_.end();
}

const assembly::HessianPattern& Objective::pattern() {
  if (!pattern_) make_pattern();
  return *pattern_;
}

void Objective::make_pattern() {
  assembly::PatternBuilder builder(node_count_);
  std::vector<Term*> moving;
  for (const auto& term : terms_) {
    if (term->has_moving_stencil())
      moving.push_back(term.get());
    else
      term->add_stencil(builder);
  }
  for (int dof = 0; dof < static_cast<int>(equal_to_.size()); ++dof)
    if (pinned_[static_cast<std::size_t>(dof)]) pinned_[static_cast<std::size_t>(representative(dof))] = true;
  for (int dof = 0; dof < static_cast<int>(equal_to_.size()); ++dof)
    if (pinned_[static_cast<std::size_t>(representative(dof))]) pinned_[static_cast<std::size_t>(dof)] = true;
  pattern_ = std::make_unique<assembly::HessianPattern>(assembly::FreeUnknowns(dim_, node_count_, pinned_),
                                                        std::move(builder));
  for (const auto& term : terms_)
    if (!term->has_moving_stencil()) term->set_pattern(*pattern_);
  moving_.reset();
  if (!moving.empty()) moving_ = std::make_unique<MovingPattern>(*pattern_, std::move(moving));
  tie_unknowns();
}

// Terms and pins are those of the pattern; stencils may have moved since.
void Objective::follow_stencils() {
  pattern();
  if (!moving_ || !moving_->follow(*pattern_)) return;
  ++stencil_version_;
  tie_unknowns();
}

void Objective::tie_unknowns() {
  equalities_.reset();
  if (!equal_to_.empty())
    equalities_ = std::make_unique<EqualityConstraints>(pattern_->unknowns(), unreduced_matrix(),
                                                        [this](int dof) { return representative(dof); });
}

const sparse::SymmetricMatrix& Objective::unreduced_matrix() const {
  return moving_ ? moving_->zero_matrix() : pattern_->zero_matrix();
}

namespace {

void accumulate(Evaluation& sum, const Evaluation& part) {
  sum.value += part.value;
  sum.points += part.points;
  sum.points_filtered += part.points_filtered;
  if (sum.worst_element < 0) sum.worst_element = part.worst_element;
}

}  // namespace

Evaluation Objective::value(const Vector& x) {
  Evaluation sum;
  for (const auto& term : terms_) accumulate(sum, term->value(x));
  return sum;
}

bool Objective::has_exact_changes() const {
  return std::any_of(terms_.begin(), terms_.end(), [](const auto& term) { return term->has_exact_change(); });
}

Evaluation Objective::value_without_exact(const Vector& x) {
  Evaluation sum;
  for (const auto& term : terms_)
    if (!term->has_exact_change()) accumulate(sum, term->value(x));
  return sum;
}

double Objective::exact_change(const Vector& x, const Vector& dx, double t) {
  double sum = 0;
  for (const auto& term : terms_)
    if (term->has_exact_change()) sum += term->change(x, dx, t);
  return sum;
}

Evaluation Objective::differentiate(const Vector& x, const projection::FilterOptions& filter,
                                    Vector& gradient, bool hessian) {
  if (hessian) follow_stencils();
  gradient.setZero(dofs());
  Evaluation sum;
  for (const auto& term : terms_) accumulate(sum, term->differentiate(x, filter, gradient, hessian));
  for (int i = 0; i < dofs(); ++i)
    if (pinned_[static_cast<std::size_t>(i)]) gradient[i] = 0;
  return sum;
}

void Objective::hessian(sparse::SymmetricMatrix& matrix) {
  std::vector<double>& values = equalities_ ? equalities_->unreduced_values() : matrix.value;
  std::vector<double>& of_fixed = moving_ ? moving_->fixed_values() : values;
  std::fill(of_fixed.begin(), of_fixed.end(), 0.0);
  for (const auto& term : terms_)
    if (!term->has_moving_stencil()) term->add_hessian(of_fixed.data());
  if (moving_) moving_->add_hessians(values);
  if (equalities_) equalities_->reduce(matrix.value);
}

const sparse::SymmetricMatrix& Objective::zero_matrix() {
  follow_stencils();
  return equalities_ ? equalities_->zero_matrix() : unreduced_matrix();
}

void Objective::restrict(const Vector& gradient, Vector& reduced) {
  const auto& unknowns = pattern().unknowns();
  reduced.setZero(equalities_ ? equalities_->zero_matrix().size : unknowns.size());
  for (int i = 0; i < unknowns.size(); ++i)
    reduced[equalities_ ? equalities_->unknown(i) : i] += gradient[unknowns.dof(i)];
}

void Objective::extend(const Vector& reduced, Vector& direction) {
  const auto& unknowns = pattern().unknowns();
  direction.setZero(dofs());
  for (int i = 0; i < unknowns.size(); ++i)
    direction[unknowns.dof(i)] = reduced[equalities_ ? equalities_->unknown(i) : i];
}

std::vector<int> Objective::axes() {
  const auto& unknowns = pattern().unknowns();
  std::vector<int> axis(
      static_cast<std::size_t>(equalities_ ? equalities_->zero_matrix().size : unknowns.size()));
  for (int i = 0; i < unknowns.size(); ++i)
    axis[static_cast<std::size_t>(equalities_ ? equalities_->unknown(i) : i)] = unknowns.dof(i) % dim_;
  return axis;
}

int Objective::element_not_finite() const {
  for (const auto& term : terms_)
    if (const int element = term->element_not_finite(); element >= 0) return element;
  return -1;
}

double Objective::max_step(const Vector& x, const Vector& dx, double limit) const {
  for (const auto& term : terms_) limit = term->max_step(x, dx, limit);
  return limit;
}

bool Objective::has_barrier() const {
  return std::any_of(terms_.begin(), terms_.end(), [](const auto& term) { return term->has_barrier(); });
}

}  // namespace isostretch::newton
