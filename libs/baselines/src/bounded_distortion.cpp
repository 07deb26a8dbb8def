// Large-scale bounded distortion mappings (Kovalsky, Aigerman, Basri, Lipman 2015) with the constraint of the
// convex problem for every element's set of matrices: from the unconstrained minimiser with all targets held,
// F is projected on the sets, and the map nearest to that is taken, among the maps on the plane that touches
// the sets there. One factorization for all. It looks for a feasible map near the start, not for an optimum.
#include "deformation.hpp"
#include "formulation.hpp"
#include "nearest_matrix_term.hpp"
#include "registry.hpp"

#include <isostretch/linalg/decompositions.hpp>
#include <isostretch/sparse/solver.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::baselines {
namespace {

using Phase = Recorder::Phase;

// The sets have this much room to the margin, so that a map that only comes near them is feasible.
constexpr double interior_slack = 1e-3;
constexpr int most_iterations = 20'000;

// R (R^T F with the eigenvalues of its symmetric part at least `least`), [element][dim * dim] column by
// column.
std::vector<double> projected(const sdp_penalty::Problem& problem, const Vector& x, double least) {
  const auto count = static_cast<std::size_t>(problem.element_count()),
             dim = static_cast<std::size_t>(problem.dim()), entries = dim * dim;
  const std::vector<double> F = deformation_gradients(problem.elements, x);
  const std::vector<double> S = constraint_matrices(problem, F);
  std::vector<double> lambda(count * dim), Q(F.size()), result(F.size());
  const auto at = [&](std::size_t r, std::size_t c, std::size_t e) { return (r + dim * c) * count + e; };
  linalg::symmetric_eigen(problem.dim(), {S.data(), lambda.data(), Q.data(), count, count});
  for (std::size_t e = 0; e < count; ++e) {
    const double* R = problem.rotations.data() + e * entries;
    double* M = result.data() + e * entries;
    for (std::size_t r = 0; r < dim; ++r)
      for (std::size_t c = 0; c < dim; ++c) M[r + dim * c] = F[at(r, c, e)];
    for (std::size_t k = 0; k < dim; ++k) {
      const double lift = std::max(0.0, least - lambda[k * count + e]);
      for (std::size_t r = 0; lift > 0 && r < dim; ++r) {
        double Rq = 0;
        for (std::size_t i = 0; i < dim; ++i) Rq += R[r + dim * i] * Q[at(i, k, e)];
        for (std::size_t c = 0; c < dim; ++c) M[r + dim * c] += lift * Rq * Q[at(c, k, e)];
      }
    }
  }
  return result;
}

class AlternatingProjections {
 public:
  AlternatingProjections(const sdp_penalty::Problem& problem)
      : problem_(without_incompressibility(problem)), objective_(problem.dim(), problem.node_count()) {
    term_ = &objective_.add<NearestMatrixTerm>(problem_);
    for (const int node : target_nodes(problem)) objective_.pin(node);
    // The fastest factorization; one is all it takes.
    sparse::Options options;
    options.backend = sparse::available_backends().front();
    solver_ = sparse::make_solver(options);
    sparse::SymmetricMatrix matrix = objective_.zero_matrix();
    Vector gradient = Vector::Zero(objective_.dofs());
    objective_.differentiate(Vector::Zero(objective_.dofs()), {}, gradient, true);
    objective_.hessian(matrix);
    analyzed_ = solver_->analyze(matrix);
    if (analyzed_) analyzed_ = solver_->factorize(matrix);
  }

  const sparse::FactorResult& factorized() const { return analyzed_; }

  // The next map; false where x does not move any more.
  bool advance(Vector& x) {
    const std::vector<double> nearest = projected(problem_, x, problem_.margin + interior_slack);
    // Half the gradient of |F - z|^2 is the adjoint of the normal F - z, weights included.
    const Vector pull = gradient_for(nearest, x), to_nearest = solved(pull);
    const double steepness = 0.5 * pull.dot(to_nearest);  // normal . A d, where the step is -d
    const double distance = value_for(nearest, x);        // normal . (A x - z)
    if (!(distance > 0) || !(steepness > 0)) return false;
    // The map nearest to z is x - d; on the plane normal . (A y - z) = 0 the step along d is longer. So the
    // step to the plane alone goes along d as well, for the metric is the same.
    x -= (distance / steepness) * to_nearest;
    return x.allFinite();
  }

 private:
  static sdp_penalty::Problem without_incompressibility(sdp_penalty::Problem problem) {
    problem.incompressibility = 0;
    return problem;
  }

  Vector gradient_for(const std::vector<double>& matrices, const Vector& x) {
    term_->set_matrices(matrices);
    Vector gradient = Vector::Zero(x.size());
    objective_.differentiate(x, {}, gradient, false);
    return gradient;
  }
  double value_for(const std::vector<double>& matrices, const Vector& x) {
    term_->set_matrices(matrices);
    return term_->value(x).value;
  }
  Vector solved(const Vector& gradient) {
    Vector right, direction(objective_.dofs());
    objective_.restrict(gradient, right);
    Vector reduced(right.size());
    solver_->solve_columns(right.data(), reduced.data(), 1);
    objective_.extend(reduced, direction);
    return direction;
  }

  sdp_penalty::Problem problem_;
  newton::Objective objective_;
  NearestMatrixTerm* term_ = nullptr;
  std::unique_ptr<sparse::Solver> solver_;
  sparse::FactorResult analyzed_;
};

Vector run(const Instance& instance, const Options& options, Recorder& recorder) {
  const sdp_penalty::Problem& problem = instance.problem;
  recorder.begin(Phase::solving);
  Vector x = with_all_targets(problem, skinned(problem));
  AlternatingProjections projections(problem);
  recorder.result().linear_solves = 2;
  if (!projections.factorized()) {
    recorder.end(Status::failed, projections.factorized().message);
    return {};
  }
  recorder.record(x);
  int& iterations = recorder.result().iterations;
  while (!recorder.ended()) {
    if (recorder.last().infeasible == 0) {
      recorder.end(Status::converged, "every element's matrix is in its set");
    } else if (iterations_left(options, recorder, most_iterations) == 0) {
      recorder.end(Status::iteration_limit, "the iteration limit is reached");
    } else if (!projections.advance(x)) {
      recorder.end(Status::stalled, "the map does not move any more");
    } else {
      ++iterations;
      recorder.record(x);
    }
  }
  return x;
}

}  // namespace

std::vector<Entry> bounded_distortion() {
  return {{{"bounded_distortion",
            "large-scale bounded distortion",
            "Kovalsky et al. 2015",
            Kind::alternative,
            {},
            false},
           run}};
}

}  // namespace isostretch::baselines
