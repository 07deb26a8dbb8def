#include <isostretch/core/error.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/newton/minimize.hpp>
#include <isostretch/newton/solver.hpp>
#include <isostretch/parameterization/tutte.hpp>

#include <doctest/doctest.h>

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace isostretch;
using newton::Status;

namespace {

struct Face {
  assembly::Elements elements;
  Vector start;

  Face() {
    const mesh::SurfaceMesh surface = mesh::procedural_face(10);
    auto arrays = mesh::flat_elements(surface);
    mesh::scale_to_total_weight(arrays);
    elements = assembly::elements_from(arrays);
    const auto tutte = parameterization::tutte_embedding(surface);
    start = Eigen::Map<const Vector>(tutte.uv.data(), tutte.uv.size());
  }

  newton::Objective objective() const {
    newton::Objective result(2, elements.node_count);
    result.add<newton::EnergyTerm>(elements, energies::make_energy("symmetric_dirichlet"));
    return result;
  }

  // Starts of several solves.
  Vector scaled(double factor) const { return factor * start; }
};

bool same(const newton::Summary& a, const newton::Summary& b) {
  return a.status == b.status && a.iterations == b.iterations && a.energy == b.energy &&
         a.factorizations == b.factorizations && a.solver == b.solver && a.trace.size() == b.trace.size();
}

// Hands everything on, and counts.
class Counting final : public sparse::Solver {
 public:
  explicit Counting(int& factorizations) : factorizations_(factorizations) {}

 private:
  sparse::FactorResult do_analyze(const sparse::SymmetricMatrix& A) override {
    const sparse::FactorResult result = inner_->analyze(A);
    statistics_.backend = inner_->statistics().backend;
    return result;
  }
  sparse::FactorResult do_factorize(const sparse::SymmetricMatrix& A) override {
    ++factorizations_;
    return inner_->factorize(A);
  }
  sparse::SolveResult do_solve(const double* b, double* x, int columns) override {
    return inner_->solve_columns(b, x, columns);
  }

  int& factorizations_;
  std::unique_ptr<sparse::Solver> inner_ = sparse::make_solver();
};

}  // namespace

TEST_CASE("solver: solves are those of minimize(), to the bit, and the analysis is made once") {
  const Face face;
  newton::Objective objective = face.objective();
  newton::Solver solver(objective);
  int solves = 0;
  for (const double factor : {1.0, 0.7, 1.5, 1.0}) {
    Vector kept = face.scaled(factor), fresh = kept;
    newton::Objective other = face.objective();
    const newton::Summary expected = newton::minimize(other, fresh);
    CHECK(same(solver.solve(kept), expected));
    CHECK(kept == fresh);
    CHECK(solver.analyses() == 1);
    ++solves;
  }
  CHECK(solves == 4);
}

TEST_CASE("solver: pins, equality constraints and terms added between solves are seen") {
  const Face face;
  newton::Objective objective = face.objective();
  newton::Solver solver(objective);
  Vector x = face.start;
  REQUIRE(solver.solve(x).converged());
  objective.pin(3);
  x = face.start;
  REQUIRE(solver.solve(x).converged());
  CHECK(solver.analyses() == 2);
  CHECK(x.segment<2>(6) == face.start.segment<2>(6));
  objective.add<newton::SoftPinTerm>(2, face.elements.node_count,
                                     std::vector<newton::SoftPin>{{7, {1.0, 1.0}, 1e6}});
  x = face.start;
  REQUIRE(solver.solve(x).converged());
  CHECK(solver.analyses() == 3);
  CHECK((x.segment<2>(14) - Eigen::Vector2d(1, 1)).norm() < 1e-2);
  for (int node = 0; node < face.elements.node_count; ++node) objective.pin(node);
  x = face.start;
  CHECK(solver.solve(x).status == Status::converged_gradient);
  CHECK(x == face.start);
}

TEST_CASE("solver: step by step is the same as at once") {
  const Face face;
  newton::Objective objective = face.objective(), other = face.objective();
  Vector at_once = face.start;
  const newton::Summary expected = newton::minimize(other, at_once);
  newton::Solver solver(objective);
  CHECK_THROWS_WITH_AS(solver.step(), doctest::Contains("step() before start()"), Error);
  CHECK_THROWS_WITH_AS(solver.positions(), doctest::Contains("before start()"), Error);
  CHECK_THROWS_WITH_AS(solver.summary(), doctest::Contains("before start()"), Error);
  int steps = 0;
  double energy = 0;
  for (bool more = solver.start(face.start); more; more = solver.step(), ++steps) {
    CHECK(solver.summary().status == Status::not_run);
    CHECK(solver.summary().iterations == steps);
    if (steps > 0) CHECK(solver.summary().energy <= energy);
    energy = solver.summary().energy;
  }
  CHECK(steps >= expected.iterations);
  CHECK(same(solver.summary(), expected));
  CHECK(solver.positions() == at_once);
  CHECK(!solver.step());  // and stays so
  CHECK(same(solver.summary(), expected));
}

TEST_CASE("solver: a linear solver that is handed in does the work") {
  const Face face;
  newton::Objective objective = face.objective(), other = face.objective();
  int factorizations = 0;
  newton::Solver solver(objective, {}, std::make_unique<Counting>(factorizations));
  Vector x = face.start, expected = face.start;
  const newton::Summary summary = solver.solve(x);
  CHECK(factorizations == summary.factorizations);
  CHECK(factorizations > 0);
  newton::minimize(other, expected);
  CHECK(x == expected);
}

TEST_CASE("solver: options of the solves that follow") {
  const Face face;
  newton::Objective objective = face.objective();
  newton::Options options;
  newton::Solver solver(objective, options);
  Vector x = face.start;
  REQUIRE(solver.solve(x).converged());
  options.max_iterations = 1;
  solver.set_options(options);
  x = face.start;
  CHECK(solver.solve(x).status == Status::stopped_iterations);
  CHECK(solver.analyses() == 1);
  options.max_iterations = 100;
  options.solver.backend = sparse::Backend::pcg;
  solver.set_options(options);
  for (int i = 2; i <= 3; ++i) {
    x = face.start;
    const newton::Summary summary = solver.solve(x);
    CHECK(summary.converged());
    CHECK(summary.solver.rfind("pcg", 0) == 0);
    CHECK(solver.analyses() == i);  // anew, so that no solve depends on those before
  }
  options.armijo = -1;
  CHECK_THROWS_AS(solver.set_options(options), Error);
  CHECK(solver.options().armijo > 0);
  CHECK_THROWS_AS(newton::Solver(objective, options), Error);
}

TEST_CASE(
    "solver: what a callback throws comes through, with the positions so far; the next solve is sound") {
  const Face face;
  newton::Objective objective = face.objective(), other = face.objective();
  newton::Solver solver(objective);
  Vector x = face.start, expected = face.start;
  CHECK_THROWS_AS(solver.solve(x,
                               [](const newton::Iteration& row, const Vector&) {
                                 if (row.iteration == 2) throw std::runtime_error("enough");
                                 return newton::CallbackAction::proceed;
                               }),
                  std::runtime_error);
  REQUIRE(x.size() == face.start.size());
  CHECK(x != face.start);
  CHECK(objective.value(x).value < objective.value(face.start).value);
  x = face.start;
  solver.solve(x);
  newton::minimize(other, expected);
  CHECK(x == expected);
}

TEST_CASE("solver: an objective that changes during a solve is refused, not written beyond") {
  const Face face;
  newton::Objective objective = face.objective();
  newton::Solver solver(objective);
  REQUIRE(solver.start(face.start));
  objective.pin(0);
  CHECK_THROWS_WITH_AS(solver.step(), doctest::Contains("added to the objective during a solve"), Error);
  Vector x = face.start;
  CHECK_THROWS_WITH_AS(solver.solve(x,
                                    [&](const newton::Iteration&, const Vector&) {
                                      objective.add_equality(1, 2, 0);
                                      return newton::CallbackAction::proceed;
                                    }),
                       doctest::Contains("during a solve"), Error);
  CHECK(x == face.start);
}

namespace {

// Adds nothing, and writes down what it is told.
class Listener final : public newton::Term {
 public:
  Listener(int& solves, std::vector<Vector>& steps) : solves_(solves), steps_(steps) {}

  void add_stencil(assembly::PatternBuilder&) const override {}
  void set_pattern(const assembly::HessianPattern&) override {}
  newton::Evaluation value(const Vector&) override { return {}; }
  newton::Evaluation differentiate(const Vector&, const projection::FilterOptions&, Vector&, bool) override {
    return {};
  }
  void add_hessian(double*) const override {}
  void begin_solve(const Vector& x) override {
    ++solves_;
    steps_ = {x};
  }
  void accepted(const Vector& x) override { steps_.push_back(x); }

 private:
  int& solves_;
  std::vector<Vector>& steps_;
};

}  // namespace

TEST_CASE("Solver: terms are told where a solve begins and of every step, and can be taken out again") {
  const Face face;
  newton::Objective objective = face.objective();
  int solves = 0;
  std::vector<Vector> steps;
  const auto& listener = objective.add<Listener>(solves, steps);
  newton::Solver solver(objective);
  std::vector<Vector> seen;
  Vector x = face.start;
  const newton::Summary summary = solver.solve(x, [&](const newton::Iteration&, const Vector& at) {
    seen.push_back(at);
    return newton::CallbackAction::proceed;
  });
  CHECK(summary.iterations > 2);
  CHECK(solves == 1);
  REQUIRE(steps.size() == seen.size());
  for (std::size_t i = 0; i < steps.size(); ++i) CHECK(steps[i] == seen[i]);
  CHECK(steps.back() == x);

  const int version = objective.version();
  objective.remove(listener);
  CHECK(objective.version() != version);
  Vector y = face.start;
  CHECK(same(solver.solve(y), summary));
  CHECK(y == x);
  CHECK(solves == 1);
  newton::Objective other = face.objective();
  const auto& kept = other.add<Listener>(solves, steps);
  CHECK_THROWS_WITH_AS(objective.remove(kept), doctest::Contains("none of its terms"), Error);
}

TEST_CASE("Solver: another energy on the same elements keeps the analysis, and is solved as if it were new") {
  const Face face;
  newton::Objective objective(2, face.elements.node_count);
  auto& term = objective.add<newton::EnergyTerm>(face.elements, energies::make_energy("symmetric_dirichlet"));
  newton::Solver solver(objective);
  Vector x = face.start;
  solver.solve(x);
  term.set_energy(energies::make_energy("symmetric_arap"));
  Vector kept = face.start, fresh = face.start;
  const newton::Summary again = solver.solve(kept);
  CHECK(solver.analyses() == 1);
  newton::Objective anew(2, face.elements.node_count);
  anew.add<newton::EnergyTerm>(face.elements, energies::make_energy("symmetric_arap"));
  CHECK(same(newton::minimize(anew, fresh), again));
  CHECK(kept == fresh);
  CHECK_THROWS_WITH_AS(term.set_energy(energies::make_energy("conformal_amips_3d")),
                       doctest::Contains("does not exist in 2D"), Error);
}

TEST_CASE(
    "Solver: a request to stop ends a solve, and a deadline in the past does so before the first step") {
  const Face face;
  newton::Objective objective = face.objective();
  const StopSource source;
  newton::Options options;
  options.stop = source.token();
  newton::Solver solver(objective, options);
  Vector x = face.start;
  const newton::Summary stopped = solver.solve(x, [&](const newton::Iteration& row, const Vector&) {
    if (row.iteration == 1) source.request_stop();
    return newton::CallbackAction::proceed;
  });
  CHECK(stopped.status == Status::stopped_by_callback);
  CHECK(stopped.outcome() == SolveStatus::interrupted);
  CHECK(stopped.iterations == 1);
  options.stop = StopToken().with_time_limit(1e-9);
  solver.set_options(options);
  Vector y = face.start;
  CHECK(solver.solve(y).outcome() == SolveStatus::time_limit);
  CHECK(y == face.start);
}
