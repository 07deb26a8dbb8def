#include "../src/distortion/bcqn.hpp"
#include "../src/distortion/determinant_filter.hpp"
#include "../src/distortion/dirichlet_metric.hpp"
#include "../src/distortion/local_global.hpp"
#include "../src/distortion/stagnation.hpp"
#include "distortion_problems.hpp"

#include <isostretch/core/error.hpp>

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

using namespace isostretch;
using baselines::DistortionProblem;
using baselines::MethodOptions;

namespace {

constexpr const char* all_methods[] = {"aqp", "quadratic_proxy", "local_global", "anderson", "lbfgs", "bcqn"};

// A cap to flatten, held at two nodes.
tests::Started pinned_flattening(const char* energy) {
  tests::Started started = tests::flattening(energies::make_energy(energy), 8);
  started.problem.pinned = {0, started.problem.elements.node_count - 1};
  return started;
}

// A long bar held at one end, bent to an arc by one radian: to straighten it costs little energy beside what
// its Laplacian thinks, so that proxies are slow.
tests::Started bent_bar(const char* energy) {
  const mesh::TetMesh bar = mesh::tet_bar(24, 2, 2, 12, 1, 1);
  auto arrays = mesh::elements(bar);
  tests::Started started{{assembly::elements_from(arrays), energies::make_energy(energy), {}}, {}};
  const mesh::Points3& points = bar.vertices;
  started.start.resize(3 * points.rows());
  constexpr double radius = 12;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double angle = points(i, 0) / radius, r = radius + points(i, 1);
    started.start.segment<3>(3 * i) << r * std::sin(angle), r * std::cos(angle) - radius, points(i, 2);
    if (points(i, 0) == 0) started.problem.pinned.push_back(static_cast<int>(i));
  }
  return started;
}

MethodOptions iterations(int count) {
  MethodOptions options;
  options.gradient_tolerance = 0;
  options.max_iterations = count;
  return options;
}

MethodOptions accuracy(double gradient, int most = 20000) {
  MethodOptions options;
  options.gradient_tolerance = gradient;
  options.max_iterations = most;
  return options;
}

std::vector<Vector> iterates(const char* method, const tests::Started& started, int count) {
  std::vector<Vector> all;
  Vector x = started.start;
  baselines::minimize(method, started.problem, x, iterations(count),
                      [&](const newton::Iteration&, const Vector& at) {
                        all.push_back(at);
                        return newton::CallbackAction::proceed;
                      });
  return all;
}

newton::Summary solved(std::string_view method, const tests::Started& started, const MethodOptions& options,
                       Vector& x) {
  x = started.start;
  return baselines::minimize(method, started.problem, x, options);
}

// First iteration at which the energy is within the share of `best` above it.
int iterations_to(const newton::Summary& summary, double best, double share) {
  for (const newton::Iteration& row : summary.trace)
    if (row.energy <= best + share * std::abs(best)) return row.iteration;
  return std::numeric_limits<int>::max();
}

double smallest_determinant(const DistortionProblem& problem, const Vector& x) {
  const assembly::EnergyAssembler assembler(problem.elements, problem.energy);
  const std::vector<double> sigma = assembler.stretches(x.data());
  const auto dim = static_cast<std::size_t>(problem.elements.dim);
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sigma.size(); i += dim) {
    double determinant = 1;
    for (std::size_t d = 0; d < dim; ++d) determinant *= sigma[i + d];
    smallest = std::min(smallest, determinant);
  }
  return smallest;
}

// Zero at pinned nodes, and without regularity otherwise.
Vector rough(const DistortionProblem& problem) {
  Vector v(problem.elements.dim * problem.elements.node_count);
  for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = std::sin(1.7 * static_cast<double>(i * i % 1009));
  for (const int node : problem.pinned)
    v.segment(problem.elements.dim * node, problem.elements.dim).setZero();
  return v;
}

void check_metric(const DistortionProblem& problem, double tolerance) {
  baselines::DirichletMetric metric(problem);
  REQUIRE(metric.factorize());
  const Vector v = rough(problem);
  Vector product, back;
  metric.product(v, product);
  metric.solve(product, back);
  CHECK((back - v).norm() <= tolerance * v.norm());
  metric.solve(v, back);
  metric.product(back, product);
  CHECK((product - v).norm() <= tolerance * v.norm());
  CHECK(product.norm() <= 1.01 * metric.norm() * back.norm());
}

}  // namespace

TEST_SUITE("first order") {
  TEST_CASE("solving and multiplying with the metric are inverse to each other") {
    check_metric(pinned_flattening("arap").problem, 1e-10);
    check_metric(tests::twisted_bar(energies::make_energy("arap")).problem, 1e-10);
    check_metric(tests::flattening(energies::make_energy("arap")).problem,
                 1e-5);  // singular but for its shift
  }

  TEST_CASE("the metric is the Hessian of sum w |F|^2, and its norm the largest eigenvalue") {
    const tests::Started started = pinned_flattening("dirichlet");
    baselines::DirichletMetric metric(started.problem);
    newton::Objective objective(2, started.problem.elements.node_count);
    objective.add<newton::EnergyTerm>(started.problem.elements, started.problem.energy);
    for (const int node : started.problem.pinned) objective.pin(node);
    const Vector v = rough(started.problem);
    Vector product, gradient;
    metric.product(v, product);
    objective.differentiate(v, {}, gradient, false);
    CHECK((product - 2 * gradient).norm() <= 1e-8 * product.norm());
    Vector eigenvector = v, next;
    for (int i = 0; i < 3000; ++i) {
      metric.product(eigenvector / eigenvector.norm(), next);
      eigenvector.swap(next);
    }
    CHECK(metric.norm() == doctest::Approx(eigenvector.norm()).epsilon(0.05));
  }

  TEST_CASE("the proxy of ARAP without acceleration is local-global, iterate by iterate") {
    for (const tests::Started& started :
         {pinned_flattening("arap"), tests::twisted_bar(energies::make_energy("arap"), 2.0)}) {
      const auto proxy = iterates("quadratic_proxy", started, 15);
      const auto local_global = iterates("local_global", started, 15);
      REQUIRE(proxy.size() == 16);
      REQUIRE(local_global.size() == 16);
      CHECK((proxy[15] - proxy[0]).norm() > 1e-3);
      for (std::size_t i = 0; i < proxy.size(); ++i)
        CHECK((proxy[i] - local_global[i]).cwiseAbs().maxCoeff() < 1e-10);
    }
  }

  TEST_CASE("local-global never raises the energy, and ends where Newton does, which it leaves alone") {
    const tests::Started started = tests::twisted_bar(energies::make_energy("arap"));
    Vector x, newton_x;
    const newton::Summary summary = solved("local_global", started, accuracy(1e-9), x);
    REQUIRE(summary.converged());
    for (std::size_t i = 1; i < summary.trace.size(); ++i)
      CHECK(summary.trace[i].energy <= summary.trace[i - 1].energy * (1 + 1e-14));
    const newton::Summary best = solved("isostretch", started, accuracy(1e-9), newton_x);
    CHECK(summary.energy == doctest::Approx(best.energy).epsilon(1e-10));
    newton::Summary ignored;
    baselines::SharedPieces pieces(started.problem, ignored);
    REQUIRE(pieces.factorize());
    baselines::LocalGlobal map(started.problem);
    Vector image;
    map.apply(newton_x, pieces, image);
    CHECK((image - newton_x).cwiseAbs().maxCoeff() < 1e-7);
  }

  TEST_CASE("acceleration pays") {
    Vector x;
    const tests::Started barrier = bent_bar("symmetric_dirichlet");
    const double best = solved("isostretch", barrier, accuracy(1e-8), x).energy;
    const int plain = iterations_to(solved("quadratic_proxy", barrier, accuracy(1e-6), x), best, 1e-6);
    const int accelerated = iterations_to(solved("aqp", barrier, accuracy(1e-6), x), best, 1e-6);
    CAPTURE(plain);
    CAPTURE(accelerated);
    CHECK(5 * accelerated < plain);
    const tests::Started arap = tests::twisted_bar(energies::make_energy("arap"));
    const newton::Summary slow = solved("local_global", arap, accuracy(1e-7), x);
    const newton::Summary fast = solved("anderson", arap, accuracy(1e-7), x);
    CAPTURE(slow.iterations);
    CAPTURE(fast.iterations);
    CHECK(fast.converged());
    CHECK(2 * fast.iterations < slow.iterations);
    for (std::size_t i = 1; i < fast.trace.size(); ++i)
      CHECK(fast.trace[i].energy <= fast.trace[i - 1].energy * (1 + 1e-14));
  }

  TEST_CASE("barriers hold, and quasi-Newton methods end where Newton does") {
    for (const tests::Started& started :
         {tests::flattening(energies::make_energy("symmetric_dirichlet")),
          tests::twisted_bar(energies::make_energy("symmetric_dirichlet"), 2.5)}) {
      Vector x;
      const double best = solved("isostretch", started, accuracy(1e-7), x).energy;
      for (const std::string method : {"aqp", "quadratic_proxy", "lbfgs", "bcqn"}) {
        CAPTURE(method);
        const newton::Summary summary = solved(method, started, accuracy(1e-6), x);
        CAPTURE(summary.message);
        CAPTURE(summary.iterations);
        CHECK(summary.converged());
        CHECK(smallest_determinant(started.problem, x) > 0);
        CHECK(summary.energy == doctest::Approx(best).epsilon(1e-8));
      }
    }
  }

  TEST_CASE("the summary agrees with itself") {
    const tests::Started started = tests::twisted_bar(energies::make_energy("arap"));
    for (const std::string method : all_methods) {
      CAPTURE(method);
      Vector x;
      const newton::Summary summary = solved(method, started, iterations(7), x);
      REQUIRE(summary.trace.size() == 8);
      CHECK(summary.factorizations == 1);
      CHECK(summary.initial_energy == summary.trace.front().energy);
      newton::Objective objective(3, started.problem.elements.node_count);
      objective.add<newton::EnergyTerm>(started.problem.elements, started.problem.energy);
      CHECK(objective.value(x).value == doctest::Approx(summary.energy).epsilon(1e-14));
      CHECK(summary.trace.back().energy == summary.energy);
      CHECK(summary.trace.back().gradient_inf_norm == summary.gradient_inf_norm);
      const newton::Seconds& seconds = summary.seconds;
      CHECK(seconds.setup + seconds.assembly + seconds.factorization + seconds.solve + seconds.line_search <=
            seconds.total);
      for (std::size_t i = 1; i < summary.trace.size(); ++i) {
        CHECK(summary.trace[i].iteration == static_cast<int>(i));
        CHECK(summary.trace[i].step > 0);
        CHECK(summary.trace[i].decrement > 0);
      }
    }
  }

  TEST_CASE("where nothing improves any more they end by themselves") {
    const tests::Started started = tests::twisted_bar(energies::make_energy("arap"));
    for (const std::string method : all_methods) {
      CAPTURE(method);
      Vector x;
      const newton::Summary summary = solved(method, started, iterations(20000), x);
      CAPTURE(summary.message);
      CHECK(summary.status == newton::Status::converged_roundoff);
      CHECK(summary.gradient_inf_norm < 1e-7);
    }
    baselines::Stagnation stagnation;
    bool found = false;
    for (int i = 0; i < 1000; ++i) found |= stagnation.found(1.0, std::pow(0.9998, i), 1e-14);
    CHECK(!found);
    for (int i = 0; i < 110; ++i) found |= stagnation.found(1.0 + 1e-14 * (i % 3), 1.0, 1e-14);
    CHECK(found);
  }

  TEST_CASE("a start outside the domain, and nothing to move") {
    tests::Started inverted = tests::flattening(energies::make_energy("symmetric_dirichlet"));
    inverted.start(Eigen::seqN(0, inverted.start.size() / 2, 2)) *= -1;
    tests::Started held = pinned_flattening("arap");
    held.problem.pinned.clear();
    for (int i = 0; i < held.problem.elements.node_count; ++i) held.problem.pinned.push_back(i);
    for (const std::string method : all_methods) {
      CAPTURE(method);
      Vector x;
      if (baselines::why_not_applicable(method, inverted.problem).empty()) {
        CHECK(solved(method, inverted, {}, x).status == newton::Status::failed_start);
        CHECK(x == inverted.start);
      }
      CHECK(solved(method, held, {}, x).status == newton::Status::converged_gradient);
      CHECK(x == held.start);
    }
  }

  TEST_CASE("the blend lies between L-BFGS and the proxy") {
    const Vector s = Vector::LinSpaced(6, 1, 2);
    CHECK(baselines::blend(1.0, s, -s) == 0);
    CHECK(baselines::blend(1.0, s, s) == 1);
    CHECK(baselines::blend(0.5, 0.1 * s, s) == doctest::Approx(0.05 * s.squaredNorm()));
    // Short steps have none of the proxy.
    CHECK(baselines::blend(1.0, 1e-9 * s, 1e-9 * s) < 1e-15);
  }

  TEST_CASE("blended quasi-Newton does not care about the unit of length") {
    tests::Started one = tests::twisted_bar(energies::make_energy("symmetric_dirichlet"), 2.5), other = one;
    constexpr double unit = 8;
    other.start *= unit;
    for (double& gradient : other.problem.elements.gradients) gradient /= unit;
    for (double& weight : other.problem.elements.weights) weight *= unit * unit * unit;
    Vector x, y;
    solved("bcqn", one, iterations(20), x);
    solved("bcqn", other, iterations(20), y);
    CHECK((y / unit - x).norm() < 1e-9 * x.norm());
  }

  TEST_CASE("the filter turns directions that would invert elements, and leaves others alone") {
    for (tests::Started& started :
         std::vector{tests::flattening(energies::make_energy("symmetric_dirichlet")),
                     tests::twisted_bar(energies::make_energy("symmetric_dirichlet"))}) {
      const int dim = started.problem.elements.dim;
      baselines::DeterminantFilter filter(started.problem);
      Vector harmless = 0.01 * started.start;
      for (const int node : started.problem.pinned) harmless.segment(dim * node, dim).setZero();
      Vector p = harmless;
      CHECK(!filter.apply(started.start, p));
      CHECK(p == harmless);
      // One node through the other side of its elements.
      const int node = started.problem.elements.node_count / 2;
      p.setZero();
      p[dim * node] = 1;
      const Vector uncorrected = p;
      const auto before = filter.linearized(started.start, p);
      CHECK(*std::min_element(before.begin(), before.end()) < -0.1);
      CHECK(filter.apply(started.start, p));
      const auto after = filter.linearized(started.start, p);
      CHECK(*std::min_element(after.begin(), after.end()) >
            0.02 * *std::min_element(before.begin(), before.end()));
      CHECK(p.dot(uncorrected) > 0);
      for (const int pinned : started.problem.pinned) CHECK(p.segment(dim * pinned, dim).norm() == 0);
    }
  }

  TEST_CASE("the filter turns a direction no more than it must") {
    // One triangle, whose third corner is sent through the opposite side, twice as far as it can go.
    DistortionProblem problem{{}, energies::make_energy("symmetric_dirichlet"), {0, 1}};
    problem.elements = {2, 3, 1, 3, {0, 1, 2}, {-1, -1, 1, 0, 0, 1}, {0.5}};
    Vector x(6), p(6), nearest(6);
    x << 0, 0, 1, 0, 0, 1;
    p << 0, 0, 0, 0, 0.3, -2;
    nearest << 0, 0, 0, 0, 0.3, -1;
    baselines::DeterminantFilter filter(problem);
    CHECK(filter.linearized(x, p).front() == doctest::Approx(-1));
    CHECK(filter.apply(x, p));
    CHECK((p - nearest).norm() < 1e-5);
    CHECK(filter.linearized(x, p).front() > -1e-5);
  }

  TEST_CASE("the filter's linearisation is the derivative of the determinants") {
    const tests::Started started = tests::twisted_bar(energies::make_energy("symmetric_dirichlet"));
    baselines::DeterminantFilter filter(started.problem);
    const Vector p = rough(started.problem), zero = Vector::Zero(p.size());
    constexpr double step = 1e-5;
    const auto linear = filter.linearized(started.start, step * p);
    const auto there = filter.linearized(started.start + step * p, zero);
    const auto here = filter.linearized(started.start, zero);
    double error = 0, change = 0;
    for (std::size_t i = 0; i < here.size(); ++i) {
      error = std::max(error, std::abs(there[i] - linear[i]));
      change = std::max(change, std::abs(there[i] - here[i]));
    }
    CHECK(error < 1e-3 * change);
  }

  TEST_CASE("results are the same for any number of threads") {
    const int threads = omp_get_max_threads();
    int checked = 0;
    for (const tests::Started& started : {tests::twisted_bar(energies::make_energy("arap")),
                                          tests::flattening(energies::make_energy("symmetric_dirichlet"))})
      for (const std::string method : all_methods) {
        if (!baselines::why_not_applicable(method, started.problem).empty()) continue;
        ++checked;
        CAPTURE(method);
        Vector one, two;
        omp_set_num_threads(1);
        solved(method, started, iterations(30), one);
        omp_set_num_threads(2);
        solved(method, started, iterations(30), two);
        CHECK(one == two);
      }
    CHECK(checked == 10);  // two are for ARAP alone
    omp_set_num_threads(threads);
  }

  TEST_CASE("local-global is refused where its local step is another, with the reason") {
    tests::Started started = tests::flattening(energies::make_energy("symmetric_dirichlet"));
    for (const std::string method : {"local_global", "anderson"}) {
      CHECK(baselines::why_not_applicable(method, started.problem).find("closest rotation") !=
            std::string::npos);
      CHECK_THROWS_WITH_AS(baselines::minimize(method, started.problem, started.start),
                           doctest::Contains("symmetric_dirichlet"), Error);
    }
    for (const std::string method : {"aqp", "quadratic_proxy", "lbfgs", "bcqn"})
      CHECK(baselines::why_not_applicable(method, started.problem).empty());
  }
}
