// Terms that couple other nodes from step to step.
#include <isostretch/energies/registry.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/newton/minimize.hpp>

#include <doctest/doctest.h>
#include <omp.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace isostretch;

namespace {

struct Pair {
  int left, right;
};

constexpr double least_gap = 0.3, margin = 0.05, stiffness = 40;

// Keeps pairs of nodes, which may be far from each other in the mesh, least_gap apart along the first axis by
// a penalty of 1/2 stiffness overlap^2. Its stencil has the pairs that are near to each other, or all of
// them.
class Gaps final : public newton::Term {
 public:
  Gaps(std::vector<Pair> pairs, bool moves) : pairs_(std::move(pairs)), moves_(moves), near_(pairs_.size()) {
    if (!moves_) near_.assign(pairs_.size(), true);
  }

  void begin_solve(const Vector& x) override { accepted(x); }
  void accepted(const Vector& x) override {
    if (!moves_) return;
    std::vector<bool> near(pairs_.size());
    for (std::size_t i = 0; i < pairs_.size(); ++i) near[i] = overlap(pairs_[i], x) > -margin;
    if (near != near_) ++version_;
    near_ = near;
  }
  bool has_moving_stencil() const override { return moves_; }
  int stencil_version() const override { return version_; }
  void add_stencil(assembly::PatternBuilder& builder) const override {
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      if (near_[i]) builder.add_pair(pairs_[i].left, pairs_[i].right);
  }
  void set_pattern(const assembly::HessianPattern& pattern) override { pattern_ = &pattern; }

  newton::Evaluation value(const Vector& x) override {
    newton::Evaluation at;
    for (const Pair& pair : pairs_) {
      const double by = std::max(0.0, overlap(pair, x));
      at.value += 0.5 * stiffness * by * by;
    }
    return at;
  }
  newton::Evaluation differentiate(const Vector& x, const projection::FilterOptions&, Vector& gradient,
                                   bool) override {
    active_.clear();
    for (const Pair& pair : pairs_) {
      const double by = overlap(pair, x);
      if (!(by > 0)) continue;
      active_.push_back(pair);
      gradient[2 * pair.left] += stiffness * by;
      gradient[2 * pair.right] -= stiffness * by;
    }
    return value(x);
  }
  void add_hessian(double* values) const override {
    const auto add = [&](int i, int j, double what) {
      if (const int place = pattern_->positions(pattern_->block(i, j))[0]; place >= 0) values[place] += what;
    };
    for (const Pair& pair : active_) {
      add(pair.left, pair.left, stiffness);
      add(pair.right, pair.right, stiffness);
      add(pair.left, pair.right, -stiffness);
    }
  }

  const std::vector<bool>& near() const { return near_; }

 private:
  static double overlap(const Pair& pair, const Vector& x) {
    return least_gap - (x[2 * pair.right] - x[2 * pair.left]);
  }

  std::vector<Pair> pairs_, active_;
  bool moves_;
  std::vector<bool> near_;
  int version_ = 0;
  const assembly::HessianPattern* pattern_ = nullptr;
};

// A square that is pulled together at its upper corners, with lower ones that start on top of each other.
struct Square {
  static constexpr int cells = 12;
  mesh::SurfaceMesh surface = mesh::grid(cells, cells);
  assembly::Elements elements = assembly::elements_from(mesh::flat_elements(surface));
  int lower_left, lower_right, upper_left, upper_right;
  Vector start;

  Square() {
    const auto corner = [&](double x, double y) {
      int best = 0;
      for (int v = 0; v < elements.node_count; ++v)
        if ((surface.vertices.row(v).head<2>() - Eigen::RowVector2d(x, y)).norm() <
            (surface.vertices.row(best).head<2>() - Eigen::RowVector2d(x, y)).norm())
          best = v;
      return best;
    };
    const double right = surface.vertices.col(0).maxCoeff(), top = surface.vertices.col(1).maxCoeff();
    lower_left = corner(0, 0), lower_right = corner(right, 0);
    upper_left = corner(0, top), upper_right = corner(right, top);
    start.resize(2 * elements.node_count);
    for (int v = 0; v < elements.node_count; ++v)
      start.segment<2>(2 * v) = surface.vertices.row(v).head<2>() / right;
    start[2 * lower_right] = start[2 * lower_left] + 0.1;
  }

  std::vector<Pair> pairs() const { return {{lower_left, lower_right}, {upper_left, upper_right}}; }

  newton::Objective objective(bool moves, const Gaps** gaps = nullptr) const {
    newton::Objective result(2, elements.node_count);
    result.add<newton::EnergyTerm>(elements, energies::make_energy("arap"));
    result.add<newton::SoftPinTerm>(
        2, elements.node_count,
        std::vector<newton::SoftPin>{{upper_left, {0.5, 1.0}, 30.0}, {upper_right, {0.5, 1.0}, 30.0}});
    const Gaps& added = result.add<Gaps>(pairs(), moves);
    if (gaps != nullptr) *gaps = &added;
    return result;
  }
};

newton::Options tight() {
  newton::Options options;
  options.scaled_gradient_tolerance = 0;
  options.gradient_tolerance = 1e-11;
  return options;
}

}  // namespace

TEST_CASE("moving stencil: the minimiser is that of all pairs at once, whatever solves the linear systems") {
  const Square square;
  int checked = 0;
  for (const sparse::Backend backend : sparse::available_backends()) {
    for (const sparse::Preconditioner preconditioner :
         {sparse::Preconditioner::block_jacobi, sparse::Preconditioner::stale_cholesky,
          sparse::Preconditioner::amg}) {
      if (backend != sparse::Backend::pcg && preconditioner != sparse::Preconditioner::block_jacobi) continue;
      CAPTURE(sparse::backend_name(backend));
      CAPTURE(sparse::preconditioner_name(preconditioner));
      newton::Options options = tight();
      options.solver.backend = backend;
      options.solver.pcg_preconditioner = preconditioner;
      newton::Objective fixed = square.objective(false), moving = square.objective(true);
      Vector x = square.start, y = square.start;
      const newton::Summary expected = newton::minimize(fixed, x, options),
                            summary = newton::minimize(moving, y, options);
      CHECK_MESSAGE(expected.converged(), expected.full_report());
      CHECK_MESSAGE(summary.converged(), summary.full_report());
      if (backend != sparse::Backend::pcg) CHECK(summary.iterations == expected.iterations);
      CHECK(summary.energy == doctest::Approx(expected.energy).epsilon(1e-13));
      CHECK((x - y).cwiseAbs().maxCoeff() < (backend == sparse::Backend::pcg ? 1e-9 : 1e-11));
      CHECK(moving.stencil_version() >= 2);
      ++checked;
    }
  }
  CHECK(checked >= 4);
}

TEST_CASE("moving stencil: pairs come and go during a solve, and the ordering is computed once") {
  const Square square;
  int checked = 0;
  for (const sparse::Backend backend : sparse::available_backends()) {
    if (backend == sparse::Backend::pcg) continue;
    CAPTURE(sparse::backend_name(backend));
    sparse::Options linear;
    linear.backend = backend;
    auto made = sparse::make_solver(linear);
    const sparse::Solver& used = *made;
    const Gaps* gaps = nullptr;
    newton::Objective objective = square.objective(true, &gaps);
    newton::Solver solver(objective, tight(), std::move(made));
    Vector x = square.start;
    std::vector<std::vector<bool>> seen;
    REQUIRE(solver
                .solve(x,
                       [&](const newton::Iteration&, const Vector&) {
                         seen.push_back(gaps->near());
                         return newton::CallbackAction::proceed;
                       })
                .converged());
    CHECK(seen.front() == std::vector<bool>{true, false});
    CHECK(seen.back() == std::vector<bool>{false, true});
    CHECK(solver.analyses() == 1);
    CHECK(used.statistics().orderings == 1);
    CHECK(used.statistics().analyze_calls == 1 + objective.stencil_version());
    CHECK(objective.stencil_version() >= 2);

    // The next solve begins where the pairs are others, with the ordering there is.
    Vector again = square.start;
    REQUIRE(solver.solve(again).converged());
    CHECK((again - x).cwiseAbs().maxCoeff() < 1e-11);
    CHECK(used.statistics().orderings == 1);
    ++checked;
  }
  CHECK(checked >= 1);
}

TEST_CASE("moving stencil: results do not depend on the number of threads, bit for bit") {
  const Square square;
  const int before = omp_get_max_threads();
  Vector results[2];
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
    newton::Objective objective = square.objective(true);
    newton::Options options = tight();
    options.solver.backend =
        sparse::Backend::eigen_ldlt;  // BLAS may sum differently for each number of threads
    results[threads - 1] = square.start;
    CHECK(newton::minimize(objective, results[threads - 1], options).converged());
    CHECK(objective.stencil_version() >= 2);
  }
  omp_set_num_threads(before);
  CHECK((results[0].array() == results[1].array()).all());
}

TEST_CASE("moving stencil: Hessians are those of all pairs, with pins and equality constraints") {
  const Square square;
  newton::Objective fixed = square.objective(false), moving = square.objective(true);
  for (newton::Objective* objective : {&fixed, &moving}) {
    objective->pin(square.lower_left);
    objective->pin(5, 1);
    objective->add_equality(square.upper_right, square.upper_right - 1, 0);
    objective->add_equality(3, 40, 1);
  }
  Vector x = square.start, gradient, d, a, b;
  int moves = 0;
  for (const double pulled : {0.0, 0.8, 0.1, 0.9}) {  // the upper corners towards each other, to and fro
    x[2 * square.upper_left] = pulled;
    moving.accepted(x);
    const int before = moving.stencil_version();
    sparse::SymmetricMatrix small = moving.zero_matrix(), large = fixed.zero_matrix();
    moves += moving.stencil_version() - before;
    small.validate();
    CHECK(small.group == large.group);
    CHECK(small.nonzeros() <= large.nonzeros());
    fixed.differentiate(x, {}, gradient, true);
    fixed.hessian(large);
    moving.differentiate(x, {}, gradient, true);
    moving.hessian(small);
    d = Vector::LinSpaced(small.size, -1, 2);
    a = small.multiply(d);
    b = large.multiply(d);
    CHECK((a - b).norm() <= 1e-14 * b.norm());
  }
  CHECK(moves >= 3);
}
