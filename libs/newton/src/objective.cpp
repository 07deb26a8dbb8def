#include <isostretch/core/error.hpp>
#include <isostretch/newton/objective.hpp>

#include <algorithm>
#include <string>

namespace isostretch::newton {

Objective::Objective(int dim, int node_count)
    : dim_(dim), node_count_(node_count), pinned_(static_cast<std::size_t>(dim * node_count), false) {
  if (dim != 2 && dim != 3) throw Error("objective of dim " + std::to_string(dim) + ": dim is 2 or 3");
}

void Objective::add_term(std::unique_ptr<Term> term) {
  terms_.push_back(std::move(term));
  pattern_.reset();
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
  pinned_[static_cast<std::size_t>(node * dim_ + axis)] = true;
  pattern_.reset();
}

bool Objective::has_pins() const {
  return std::find(pinned_.begin(), pinned_.end(), true) != pinned_.end();
}

const assembly::HessianPattern& Objective::pattern() {
  if (!pattern_) {
    assembly::PatternBuilder builder(node_count_);
    for (const auto& term : terms_) term->add_to(builder);
    pattern_ = std::make_unique<assembly::HessianPattern>(assembly::FreeUnknowns(dim_, node_count_, pinned_),
                                                          std::move(builder));
    for (const auto& term : terms_) term->bind(*pattern_);
  }
  return *pattern_;
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

Evaluation Objective::differentiate(const Vector& x, const projection::FilterOptions& filter,
                                    Vector& gradient, bool hessian) {
  if (hessian) pattern();
  gradient.setZero(dofs());
  Evaluation sum;
  for (const auto& term : terms_) accumulate(sum, term->differentiate(x, filter, gradient, hessian));
  for (int i = 0; i < dofs(); ++i)
    if (pinned_[static_cast<std::size_t>(i)]) gradient[i] = 0;
  return sum;
}

void Objective::hessian(sparse::SymmetricMatrix& matrix) {
  std::fill(matrix.value.begin(), matrix.value.end(), 0.0);
  for (const auto& term : terms_) term->add_hessian(matrix.value.data());
}

double Objective::max_step(const Vector& x, const Vector& dx, double limit) const {
  for (const auto& term : terms_) limit = term->max_step(x, dx, limit);
  return limit;
}

}  // namespace isostretch::newton
