// Two triangles assembled: the Hessian against a difference of gradients, at rest and stretched.
#include "expect.hpp"

#include <isostretch/assembly/energy_assembler.hpp>
#include <isostretch/energies/registry.hpp>

#include <Eigen/Core>

int main() {
  isostretch::assembly::Elements elements;
  elements.dim = 2;
  elements.nodes_per_element = 3;
  elements.points_per_element = 1;
  elements.node_count = 4;
  elements.nodes = {0, 1, 2, 2, 1, 3};
  elements.gradients = {-1, -1, 1, 0, 0, 1, -1, 0, 0, -1, 1, 1};  // the unit square, cut along a diagonal
  elements.weights = {0.5, 0.5};
  isostretch::assembly::EnergyAssembler assembler(elements,
                                                  isostretch::energies::make_energy("stable_neo_hookean"));
  isostretch::assembly::PatternBuilder builder(4);
  assembler.add_stencil(builder);
  const isostretch::assembly::HessianPattern pattern(isostretch::assembly::FreeUnknowns(2, 4),
                                                     std::move(builder));
  assembler.set_pattern(pattern);

  Eigen::VectorXd x(8), direction(8);
  x << 0, 0, 1.3, 0.1, -0.2, 0.8, 1, 1.1;
  direction << 0.3, -0.1, 0.2, 0.5, -0.4, 0.1, 0.6, -0.7;
  isostretch::projection::FilterOptions exact;
  exact.filter = isostretch::projection::Filter::none;
  auto H = pattern.zero_matrix();
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(8);
  assembler.differentiate(x.data(), exact, gradient.data(), true);
  assembler.add_hessian(H.value.data());

  const auto gradient_at = [&](const Eigen::VectorXd& y) {
    Eigen::VectorXd g = Eigen::VectorXd::Zero(8);
    assembler.differentiate(y.data(), exact, g.data(), false);
    return g;
  };
  const double h = 1e-6;
  const Eigen::VectorXd difference =
      (gradient_at(x + h * direction) - gradient_at(x - h * direction)) / (2 * h);
  EXPECT((H.multiply(direction) - difference).norm() < 1e-7 * difference.norm());
}
