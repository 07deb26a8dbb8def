// Energies of the literature that are not built in, as one would type them.
#include <isostretch/expressions/expression.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/newton/minimize.hpp>
#include <isostretch/projection/projection.hpp>
#include <isostretch/testing/deformation_samples.hpp>
#include <isostretch/testing/derivative_checks.hpp>

#include <doctest/doctest.h>

#include <map>
#include <random>
#include <string>

using namespace isostretch;

namespace {

struct Known {
  const char* name;
  const char* text;
  std::map<std::string, double> parameters;
};

const Known known[] = {
    {"Ogden 1972, compressible",
     "mu1/a1*(sum((s*J^(-1/d))^a1) - d) + mu2/a2*(sum((s*J^(-1/d))^a2) - d) + K/2*(J - 1)^2",
     {{"mu1", 1.2}, {"a1", 1.3}, {"mu2", -0.3}, {"a2", -2}, {"K", 5}}},
    {"Yeoh 1993",
     "c1*(I2*J^(-2/d) - d) + c2*(I2*J^(-2/d) - d)^2 + c3*(I2*J^(-2/d) - d)^3 + K/2*(J - 1)^2",
     {{"c1", 0.5}, {"c2", -0.02}, {"c3", 0.03}, {"K", 5}}},
    {"Gent 1996",
     "if(I2*J^(-2/d) - d < Jm, -mu*Jm/2*log(1 - (I2*J^(-2/d) - d)/Jm), 1/0) + K/2*((J^2 - 1)/2 - log(J))",
     {{"mu", 1}, {"Jm", 20}, {"K", 5}}},
    {"Blatz, Ko 1962", "mu/2*(sum(1/s^2) + 2*J - d - 2)", {{"mu", 1}}},
    {"Seth, Hill: strains (s^(2m) - 1) / (2m)",
     "mu*sum(((s^(2*m) - 1)/(2*m))^2) + lambda/2*sum((s^(2*m) - 1)/(2*m))^2",
     {{"mu", 1}, {"lambda", 2}, {"m", 0.75}}},
    {"Ciarlet, Geymonat 1982",
     "mu/2*(I2 - d) + lambda/4*(J^2 - 1) - (lambda/2 + mu)*log(J)",
     {{"mu", 1}, {"lambda", 2}}},
    {"Mooney, Rivlin, compressible in the plane and in space",
     "c1*(I2*J^(-2/d) - d) + c2*(sum(1/s^2)*J^(2/d) - d) + K/2*(J - 1)^2",
     {{"c1", 0.4}, {"c2", 0.1}, {"K", 4}}},
    {"Fung, with the norm of Green's strain",
     "c/2*(exp(a/4*sum((s^2 - 1)^2)) - 1) + K/2*log(J)^2",
     {{"c", 0.8}, {"a", 0.7}, {"K", 2}}},
    {"Arruda, Boyce, with Cohen's inverse Langevin function",
     "mu*N*(I2*J^(-2/d)/(2*d*N) - log(1 - I2*J^(-2/d)/(d*N))) + K/2*(J - 1)^2",
     {{"mu", 0.4}, {"N", 6}, {"K", 4}}},
    {"Green's strain, squared", "sum((s^2 - 1)^2)/4", {}},
    {"Simo, Taylor 1982", "mu/2*(I2*J^(-2/d) - d) + K/4*((J - 1)^2 + log(J)^2)", {{"mu", 1}, {"K", 3}}},
    {"Knowles 1977",
     "mu/(2*b)*((1 + b/n*(I2*J^(-2/d) - d))^n - 1) + K/2*(J - 1)^2",
     {{"mu", 1}, {"b", 0.5}, {"n", 1.4}, {"K", 3}}},
};

template <int Dim>
void check_derivatives(const energies::AnyEnergy& energy) {
  constexpr projection::FilterOptions exact{projection::Filter::none, 0.0, 0.0, nullptr};
  using Matrix = Eigen::Matrix<double, Dim, Dim>;
  const auto matrix = [](const Eigen::VectorXd& f) { return Matrix(Eigen::Map<const Matrix>(f.data())); };
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> factor(0.75, 1.35);
  for (int i = 0; i < 10; ++i) {
    Eigen::Matrix<double, Dim, 1> sigma;
    for (int e = 0; e < Dim; ++e) sigma[e] = factor(generator);
    if (i == 0) sigma.setConstant(1.1);
    const Matrix F = testing::with_stretch<Dim>(sigma, generator);
    const auto report = testing::check_derivatives(
        [&](const Eigen::VectorXd& f) { return projection::evaluate<Dim>(energy, matrix(f), exact).psi; },
        [&](const Eigen::VectorXd& f) -> Eigen::VectorXd {
          const Matrix P = projection::evaluate<Dim>(energy, matrix(f), exact).P;
          return Eigen::Map<const Eigen::VectorXd>(P.data(), P.size());
        },
        [&](const Eigen::VectorXd& f, const Eigen::VectorXd& d) -> Eigen::VectorXd {
          return projection::evaluate<Dim>(energy, matrix(f), exact).H * d;
        },
        Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(F.data(), F.size())));
    CHECK_MESSAGE(report.ok(), report.text());
  }
}

// A bar held at one end, the other drawn out by a tenth and lowered as much.
void check_bar(const energies::AnyEnergy& energy) {
  const mesh::TetMesh bar = mesh::tet_bar(4, 2, 2, 2, 1, 1);
  const auto elements = assembly::elements_from(mesh::elements(bar));
  newton::Objective objective(3, elements.node_count);
  const auto& term = objective.add<newton::EnergyTerm>(elements, energy);
  Vector x(3 * bar.vertices.rows());
  for (Eigen::Index i = 0; i < bar.vertices.rows(); ++i) {
    const double along = bar.vertices(i, 0);
    x.segment<3>(3 * i) = bar.vertices.row(i).transpose() + along * Eigen::Vector3d(0.1, 0, -0.1);
    if (along == 0 || along == 2) objective.pin(static_cast<int>(i));
  }
  const newton::Summary summary = newton::minimize(objective, x);
  CHECK_MESSAGE(summary.converged(), summary.brief_report());
  CHECK(summary.energy < summary.initial_energy);
  double least = 1;
  const std::vector<double> sigma = term.assembler().stretches(x.data());
  for (std::size_t e = 0; e < sigma.size(); e += 3)
    least = std::min(least, sigma[e] * sigma[e + 1] * sigma[e + 2]);
  CHECK(least > 0);
}

}  // namespace

TEST_SUITE("typed energies of the literature") {
  TEST_CASE("they match finite differences and deform a bar") {
    for (const Known& one : known) {
      CAPTURE(one.name);
      const auto energy = expressions::parse_energy(one.text, one.parameters);
      REQUIRE(energy.supports(3));
      check_derivatives<3>(energy);
      if (energy.supports(2)) check_derivatives<2>(energy);
      check_bar(energy);
    }
  }
}
