// What the papers of the Hessian-based rivals state of themselves.
#include "../src/distortion/chen_weber_rule.hpp"
#include "../src/distortion/composite_majorization_rules.hpp"
#include "../src/distortion/eigenvalue_rule.hpp"
#include "../src/distortion/killing.hpp"
#include "../src/distortion/mcadams_rule.hpp"
#include "../src/distortion/slim.hpp"
#include "../src/distortion/smith_2018_rule.hpp"
#include "../src/distortion/stomakhin_rule.hpp"
#include "../src/distortion/teran_rule.hpp"
#include "distortion_problems.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/linalg/decompositions.hpp>
#include <isostretch/newton/objective.hpp>
#include <isostretch/projection/projection.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

using namespace isostretch;
using baselines::MethodOptions;
using energies::AnyEnergy;
using energies::make_energy;
using projection::Filter;

namespace {

constexpr projection::FilterOptions exact{Filter::none, 0.0, 0.0, nullptr};

template <int Dim>
using Square = Eigen::Matrix<double, Dim, Dim>;

// Stretched by factors of 0.4 to 2.5 and turned.
template <int Dim>
std::vector<Square<Dim>> samples(int count) {
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> exponent(-0.4, 0.4);
  std::vector<Square<Dim>> all;
  for (int i = 0; i < count; ++i) {
    Square<Dim> M = Square<Dim>::NullaryExpr([&] { return normal(generator); });
    const auto svd = linalg::signed_svd<Dim>(M);
    Eigen::Matrix<double, Dim, 1> sigma;
    for (int e = 0; e < Dim; ++e) sigma[e] = std::pow(10.0, exponent(generator));
    std::sort(sigma.data(), sigma.data() + Dim, std::greater<>());
    all.push_back(svd.U * sigma.asDiagonal() * svd.V.transpose());
  }
  return all;
}

template <int Dim>
auto hessian(const AnyEnergy& energy, const Square<Dim>& F, const projection::FilterOptions& filter = exact) {
  return projection::evaluate<Dim>(energy, F, filter).H;
}

template <int Dim, class Rule>
void check_nearest(const AnyEnergy& energy, Rule rule) {
  const AnyEnergy ruled = baselines::with_rule(energy, rule);
  int indefinite = 0;
  for (const Square<Dim>& F : samples<Dim>(200)) {
    const auto clamped = hessian<Dim>(energy, F, {});
    CHECK((hessian<Dim>(ruled, F) - clamped).norm() <= 1e-10 * clamped.norm());
    indefinite += (clamped - hessian<Dim>(energy, F)).norm() > 1e-10 * clamped.norm();
  }
  CHECK(indefinite > 20);
}

double least_eigenvalue(const Eigen::MatrixXd& H) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues().minCoeff();
}

// Gradient and Hessian of one term over all positions.
struct Model {
  Vector gradient;
  Eigen::MatrixXd hessian;
};

template <class Term>
Model model_of(const baselines::DistortionProblem& problem, const Vector& x) {
  newton::Objective objective(problem.elements.dim, problem.elements.node_count);
  objective.add<Term>(problem);
  Model model;
  objective.differentiate(x, exact, model.gradient, true);
  sparse::SymmetricMatrix matrix = objective.zero_matrix();
  objective.hessian(matrix);
  model.hessian = Eigen::MatrixXd::Zero(matrix.size, matrix.size);
  for (int j = 0; j < matrix.size; ++j)
    for (int k = matrix.column_start[static_cast<std::size_t>(j)];
         k < matrix.column_start[static_cast<std::size_t>(j) + 1]; ++k) {
      const int i = matrix.row[static_cast<std::size_t>(k)];
      model.hessian(i, j) = model.hessian(j, i) = matrix.value[static_cast<std::size_t>(k)];
    }
  return model;
}

// Positions of the corners of one element of any shape, and the problem that it is alone.
template <int Dim>
tests::Started one_element(const AnyEnergy& energy, const Square<Dim>& F) {
  assembly::Elements elements;
  elements.dim = Dim;
  elements.nodes_per_element = elements.node_count = Dim + 1;
  elements.points_per_element = 1;
  elements.weights = {0.7};
  Eigen::Matrix<double, Dim, Dim + 1> rest = Eigen::Matrix<double, Dim, Dim + 1>::Zero();
  for (int a = 0; a < Dim; ++a) rest(a, a + 1) = 1.0 + 0.3 * a, rest((a + 1) % Dim, a + 1) += 0.2;
  const Square<Dim> edges = rest.template rightCols<Dim>();
  Eigen::Matrix<double, Dim, Dim + 1> gradients;
  gradients.template rightCols<Dim>() = edges.inverse().transpose();
  gradients.col(0) = -gradients.template rightCols<Dim>().rowwise().sum();
  elements.gradients.assign(gradients.data(), gradients.data() + gradients.size());
  for (int a = 0; a <= Dim; ++a) elements.nodes.push_back(a);
  const Eigen::Matrix<double, Dim, Dim + 1> positions = F * rest;
  return {{elements, energy, {}}, Eigen::Map<const Vector>(positions.data(), positions.size())};
}

void check_same_path(const tests::Started& started, const char* one, const char* other, double tolerance) {
  CAPTURE(one);
  CAPTURE(other);
  MethodOptions options;
  options.gradient_tolerance = 1e-6;
  Vector x = started.start, y = started.start;
  const auto first = baselines::minimize(one, started.problem, x, options),
             second = baselines::minimize(other, started.problem, y, options);
  REQUIRE(first.converged());
  REQUIRE(first.trace.size() == second.trace.size());
  CHECK(first.iterations > 4);
  for (std::size_t i = 0; i < first.trace.size(); ++i)
    CHECK(first.trace[i].energy == doctest::Approx(second.trace[i].energy).epsilon(tolerance));
}

}  // namespace

TEST_SUITE("fidelity") {
  TEST_CASE("numerical projections at a point find the nearest semi-definite matrix") {
    for (const char* name : {"symmetric_dirichlet", "arap", "st_venant_kirchhoff", "stable_neo_hookean"}) {
      CAPTURE(name);
      check_nearest<2>(make_energy(name), baselines::TeranRule{});
      check_nearest<3>(make_energy(name), baselines::TeranRule{});
      check_nearest<2>(make_energy(name), baselines::StomakhinRule{});
      check_nearest<3>(make_energy(name), baselines::StomakhinRule{});
    }
    check_nearest<2>(make_energy("arap"), baselines::McAdamsRule{});
    check_nearest<3>(make_energy("corotational"), baselines::McAdamsRule{});
  }

  TEST_CASE("all projections of a point take the same path") {
    const auto cap = tests::flattening(make_energy("symmetric_dirichlet"));
    const auto bar = tests::twisted_bar(make_energy("symmetric_dirichlet"));
    for (const char* method : {"numerical_point", "teran", "stomakhin"}) {
      check_same_path(cap, "analytic", method, 1e-9);
      check_same_path(bar, "analytic", method, 1e-9);
    }
  }

  TEST_CASE("composite majorization takes the path of projected Newton on symmetric Dirichlet") {
    check_same_path(tests::flattening(make_energy("symmetric_dirichlet")), "analytic",
                    "composite_majorization", 1e-8);
  }

  TEST_CASE("majorizers lie above the Hessian, and the one of alpha and beta above ARAP everywhere") {
    const AnyEnergy arap = make_energy("arap"), dirichlet = make_energy("symmetric_dirichlet");
    const AnyEnergy alpha_beta = baselines::with_rule<baselines::AlphaBetaRule>(arap);
    const auto all = samples<2>(60);
    for (const auto& F : all) {
      CHECK((hessian<2>(alpha_beta, F) - 2 * Eigen::Matrix4d::Identity()).norm() < 1e-14);
      for (const AnyEnergy& energy : {arap, dirichlet}) {
        const Eigen::Matrix4d H = hessian<2>(energy, F);
        const double rounding = 1e-12 * H.norm();
        CHECK(least_eigenvalue(hessian<2>(baselines::with_rule<baselines::ConesRule>(energy), F) - H) >
              -rounding);
        CHECK(least_eigenvalue(hessian<2>(baselines::with_rule<baselines::SingularValuesRule>(energy), F) -
                               H) > -rounding);
      }
      const auto at = projection::evaluate<2>(arap, F, exact);
      for (const auto& G : all)
        CHECK(projection::evaluate<2>(arap, G, exact).psi <=
              at.psi + (at.P.array() * (G - F).array()).sum() + (G - F).squaredNorm() + 1e-12);
    }
  }

  TEST_CASE("the majorization of alpha and beta takes the steps of local-global") {
    auto cap = tests::flattening(make_energy("arap"));
    cap.problem.pinned = {0, 5};  // without pins each loses the translation in its own digits
    MethodOptions options;
    options.gradient_tolerance = 0;
    options.max_iterations = 12;
    Vector x = cap.start, y = cap.start;
    baselines::minimize("composite_majorization_ab", cap.problem, x, options);
    baselines::minimize("local_global", cap.problem, y, options);
    CHECK((x - y).norm() < 1e-8 * y.norm());
  }

  TEST_CASE("Smith 2018 is exact where nothing is negative, and above the nearest elsewhere") {
    for (const char* name : {"stable_neo_hookean", "stable_neo_hookean_log"}) {
      CAPTURE(name);
      const AnyEnergy energy = make_energy(name),
                      ruled = baselines::with_rule<baselines::Smith2018Rule>(energy);
      int above = 0, exactly = 0;
      for (const auto& F : samples<3>(300)) {
        const auto H = hessian<3>(energy, F), R = hessian<3>(ruled, F), clamped = hessian<3>(energy, F, {});
        const double rounding = 1e-12 * H.norm();
        CHECK(least_eigenvalue(R - H) > -rounding);
        CHECK(least_eigenvalue(R) > -rounding);
        exactly += (R - H).norm() < rounding;
        above += (R - clamped).norm() > 1e-6 * H.norm();
      }
      CHECK(exactly > 5);
      CHECK(above > 5);
    }
    check_nearest<2>(make_energy("stable_neo_hookean"), baselines::TeranRule{});
  }

  TEST_CASE(
      "Chen and Weber's eigenvectors are 0 / 0 at conformal F, lose digits nearby, and are right elsewhere") {
    const auto scaling = [](double a, double b) {
      const auto d = energies::derivatives_at(make_energy("st_venant_kirchhoff"),
                                              invariants::PrincipalStretches<2, double>{{a, b}});
      return baselines::scaling_matrix<2>(d);
    };
    const auto error = [&](double a, double b) {
      const Eigen::Matrix2d A = scaling(a, b), best = baselines::nearest_semidefinite<2>(A);
      return (baselines::chen_weber_scaling(A) - best).norm() / A.norm();
    };
    CHECK(!std::isfinite(error(0.65, 0.65)));
    CHECK(error(0.7, 0.2) < 1e-14);
    double worst = 0;
    for (int i = 1; i < 40; ++i) worst = std::max(worst, error(0.65 + 1e-12 * i, 0.65));
    CHECK(worst > 1e-12);  // four digits and more
    // The method itself is safe there.
    check_nearest<2>(make_energy("symmetric_dirichlet"), baselines::ChenWeberRule{});
    const AnyEnergy svk = make_energy("st_venant_kirchhoff", {{"mu", 1}, {"kappa", 1}});
    const Eigen::Matrix2d conformal = 0.65 * Eigen::Matrix2d::Identity();
    CHECK((hessian<2>(baselines::with_rule<baselines::ChenWeberRule>(svk), conformal) -
           hessian<2>(svk, conformal, {}))
              .norm() < 1e-12);
  }

  TEST_CASE("SLIM's proxy has the gradient of the energy") {
    const auto check = [](auto dim, const char* name, auto free_stretch) {
      constexpr int Dim = decltype(dim)::value;
      CAPTURE(name);
      for (const Square<Dim>& F : samples<Dim>(20)) {
        const auto started = one_element<Dim>(make_energy(name), F);
        const Model model = model_of<baselines::SlimTerm>(started.problem, started.start);
        const auto svd = linalg::signed_svd<Dim>(F);
        const Square<Dim> target = free_stretch(svd.sigma) * svd.U * svd.V.transpose();
        const Vector nearest = one_element<Dim>(make_energy(name), target).start;
        const Vector gradient = model.hessian * (started.start - nearest);
        CHECK((gradient - model.gradient).norm() < 1e-11 * model.gradient.norm());
      }
    };
    const auto one = [](const auto&) { return 1.0; };
    for (const char* name : {"arap", "symmetric_arap", "symmetric_dirichlet", "symmetric_gradient"}) {
      check(std::integral_constant<int, 2>{}, name, one);
      check(std::integral_constant<int, 3>{}, name, one);
    }
    check(std::integral_constant<int, 2>{}, "mips_2d", [](const auto& s) { return std::sqrt(s[0] * s[1]); });
    check(std::integral_constant<int, 3>{}, "conformal_amips_3d",
          [](const auto& s) { return s.norm() / std::sqrt(3.0); });
  }

  TEST_CASE("SLIM's energy falls in every step, and its curvature at rest is the energy's limit") {
    const auto cap = tests::flattening(make_energy("symmetric_dirichlet"));
    Vector x = cap.start;
    const auto summary = baselines::minimize("slim", cap.problem, x);
    REQUIRE(summary.converged());
    for (std::size_t i = 1; i < summary.trace.size(); ++i)
      CHECK(summary.trace[i].energy < summary.trace[i - 1].energy);
    // Where the quotient of the weights is 0 / 0 it goes on as it was.
    const auto check = [](auto dim, const char* name) {
      constexpr int Dim = decltype(dim)::value;
      CAPTURE(name);
      const Square<Dim> rest = 1.3 * Square<Dim>::Identity();
      const double scale = std::string(name) == "symmetric_dirichlet" ? 1 / 1.3 : 1;
      Square<Dim> near = scale * rest;
      near(0, 0) *= 1 + 1e-6;
      const auto at = one_element<Dim>(make_energy(name), scale * rest),
                 by = one_element<Dim>(make_energy(name), near);
      const Eigen::MatrixXd H = model_of<baselines::SlimTerm>(at.problem, at.start).hessian;
      CHECK((model_of<baselines::SlimTerm>(by.problem, by.start).hessian - H).norm() < 1e-4 * H.norm());
    };
    check(std::integral_constant<int, 2>{}, "symmetric_dirichlet");
    check(std::integral_constant<int, 2>{}, "mips_2d");
    check(std::integral_constant<int, 3>{}, "conformal_amips_3d");
  }

  TEST_CASE(
      "Killing's metric is the Hessian of symmetric Dirichlet at rest, and isometries cost nothing in it") {
    const auto check = [](auto dim) {
      constexpr int Dim = decltype(dim)::value;
      const AnyEnergy energy = make_energy("symmetric_dirichlet");
      const auto rest = one_element<Dim>(energy, Square<Dim>::Identity());
      const Model model = model_of<baselines::KillingTerm>(rest.problem, rest.start);
      newton::Objective objective(Dim, Dim + 1);
      objective.add<newton::EnergyTerm>(rest.problem.elements, energy);
      Vector gradient;
      objective.differentiate(rest.start, exact, gradient, true);
      sparse::SymmetricMatrix matrix = objective.zero_matrix();
      objective.hessian(matrix);
      const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(matrix.size, matrix.size);
      for (int j = 0; j < matrix.size; ++j)
        CHECK((matrix.multiply(identity.col(j)) - model.hessian.col(j)).norm() < 1e-12);
      for (const Square<Dim>& F : samples<Dim>(20)) {
        const auto started = one_element<Dim>(energy, F);
        const Model deformed = model_of<baselines::KillingTerm>(started.problem, started.start);
        Square<Dim> spin = Square<Dim>::Zero();
        spin(0, Dim - 1) = 1, spin(Dim - 1, 0) = -1;
        Vector field = started.start;
        for (int a = 0; a <= Dim; ++a)
          field.template segment<Dim>(Dim * a) = spin * started.start.template segment<Dim>(Dim * a);
        CHECK((deformed.hessian * field).norm() < 1e-12 * deformed.hessian.norm() * field.norm());
        CHECK(least_eigenvalue(deformed.hessian) > -1e-12 * deformed.hessian.norm());
      }
    };
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
  }

  TEST_CASE("methods say what they do not suit") {
    const auto cap = tests::flattening(make_energy("symmetric_dirichlet"), 4);
    const auto bar = tests::twisted_bar(make_energy("arap"));
    CHECK(baselines::why_not_applicable("composite_majorization", bar.problem) == "it exists in 2D only");
    CHECK(baselines::why_not_applicable("mcadams", cap.problem).find("arap, corotational") !=
          std::string::npos);
    CHECK(baselines::why_not_applicable("killing", bar.problem).find("inverting") != std::string::npos);
    Vector x = bar.start;
    CHECK_THROWS_WITH_AS(baselines::minimize("chen_weber", bar.problem, x),
                         doctest::Contains("'chen_weber' does not suit the problem: it exists in 2D only"),
                         Error);
  }
}
