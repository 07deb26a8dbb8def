#include "local_global.hpp"

#include "method_registry.hpp"

#include <isostretch/assembly/deformation_operator.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/linalg/decompositions.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace isostretch::baselines {
namespace {

// Adds 2 w M g_a to the entries of every node a of a point's element.
template <int Dim>
void scatter(const assembly::Elements& elements, std::size_t point, linalg::Mat<Dim> M, Vector& right) {
  const assembly::DeformationOperator<Dim> deformation(elements);
  const int* nodes = deformation.nodes(point);
  M *= 2 * elements.weights[point];
  deformation.apply_transposed(point, M,
                               [&](int a, int r, double value) { right[Dim * nodes[a] + r] += value; });
}

class LocalGlobalMethod final : public FirstOrderMethod {
 public:
  explicit LocalGlobalMethod(const DistortionProblem& problem) : map_(problem) {}

  Step step(const Iterate& at, SharedPieces& pieces) override {
    Vector next;
    map_.apply(at.x, pieces, next);
    return full_step_to(at, std::move(next));
  }

 private:
  LocalGlobal map_;
};

newton::Summary run(const DistortionProblem& problem, Vector& x, const MethodOptions& options,
                    const newton::IterationCallback& callback) {
  LocalGlobalMethod method(problem);
  return minimize_first_order(method, problem, x, options, callback);
}

}  // namespace

LocalGlobal::LocalGlobal(const DistortionProblem& problem)
    : elements_(problem.elements), points_(elements_.weights.size()) {
  const std::size_t entries = points_ * static_cast<std::size_t>(elements_.dim * elements_.dim);
  deformation_.resize(entries);
  rotations_.resize(entries);
}

template <int Dim>
void LocalGlobal::local_step(const Vector& x) {
  constexpr std::size_t batch_size = 1024;
#pragma omp parallel for schedule(static)
  for (std::size_t first = 0; first < points_; first += batch_size) {
    const std::size_t last = std::min(first + batch_size, points_);
    assembly::deformation_gradients(elements_, x.data(), first, last - first, deformation_.data() + first,
                                    points_);
    linalg::PolarBatch batch;
    batch.F = deformation_.data() + first;
    batch.R = rotations_.data() + first;
    batch.count = last - first;
    batch.stride = points_;
    linalg::polar(Dim, batch);
  }
}

template <int Dim>
void LocalGlobal::add_rotations(Vector& right) const {
  for (std::size_t i = 0; i < points_; ++i) {
    linalg::Mat<Dim> R;
    for (std::size_t c = 0; c < Dim; ++c)
      for (std::size_t r = 0; r < Dim; ++r) R.m[r][c] = rotations_[(r + Dim * c) * points_ + i];
    scatter(elements_, i, R, right);
  }
}

template <int Dim>
void LocalGlobal::find_pull_of_pins() {
  pull_of_pins_.setZero(pins_alone_.size());
  const assembly::DeformationOperator<Dim> deformation(elements_);
  for (std::size_t i = 0; i < points_; ++i)
    scatter(elements_, i, deformation.apply(i, pins_alone_.data()), pull_of_pins_);
}

template <int Dim>
void LocalGlobal::right_side(const Vector& x, const DirichletMetric& metric, Vector& right) {
  if (pins_alone_.size() == 0) {
    pins_alone_ = x;
    metric.clear_unknowns(pins_alone_);
    find_pull_of_pins<Dim>();
  }
  local_step<Dim>(x);
  right = metric.shift() * x - pull_of_pins_;
  add_rotations<Dim>(right);
}

void LocalGlobal::apply(const Vector& x, SharedPieces& pieces, Vector& result) {
  Vector right;
  {
    const ScopedTimer timer(pieces.seconds().assembly);
    if (elements_.dim == 2)
      right_side<2>(x, pieces.metric(), right);
    else
      right_side<3>(x, pieces.metric(), right);
  }
  pieces.solve(right, result);
  result += pins_alone_;
}

std::string why_not_local_global(const DistortionProblem& problem) {
  if (problem.energy.name() == "arap") return "";
  return "its local step is the closest rotation, which minimises 'arap' and not '" + problem.energy.name() +
         "'";
}

Step full_step_to(const Iterate& at, Vector next) {
  Step step;
  step.taken = true;
  step.row.step = 1;
  step.row.decrement = 0.5 * at.gradient.dot(at.x - next);
  step.x.swap(next);
  return step;
}

std::vector<Method> local_global_methods() {
  return {{{"local_global", "local-global", "Sorkine, Alexa 2007; Liu et al. 2008", Family::constant_metric},
           why_not_local_global,
           run}};
}

}  // namespace isostretch::baselines
