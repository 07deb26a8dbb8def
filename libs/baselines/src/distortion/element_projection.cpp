// Projection of the whole Hessian of an element, 6 x 6 for triangles and 12 x 12 for tetrahedra, by a
// numerical eigen-decomposition: what most programs do, TinyAD for one.
#include "method_registry.hpp"
#include "modelled_energy_term.hpp"
#include "newton_driver.hpp"
#include "scaling_matrix.hpp"

#include <array>
#include <cstddef>
#include <memory>

namespace isostretch::baselines {
namespace {

class ElementProjection final : public ModelledEnergyTerm {
 public:
  using ModelledEnergyTerm::ModelledEnergyTerm;

 private:
  bool wants_exact() const override { return true; }

  void model(const Vector&) override {
#pragma omp parallel for schedule(static)
    for (int place = 0; place < element_count(); ++place) {
      if (elements().dim == 2)
        nodes() == 3 ? project<2, 6>(hessian_at(place)) : project<2, 12>(hessian_at(place));
      else
        nodes() == 4 ? project<3, 12>(hessian_at(place)) : project<3, 30>(hessian_at(place));
    }
  }

  // Of at most Capacity rows.
  template <int Dim, int Capacity>
  void project(double* hessian) const {
    const int size = Dim * nodes();
    std::array<double, Capacity * Capacity> K;
    const auto entry = [&](int a, int b, int c, int d) -> double& {
      return K[static_cast<std::size_t>((Dim * a + c) * size + Dim * b + d)];
    };
    for_each_block<Dim>(hessian, [&](int a, int b, const auto& block) {
      for (int c = 0; c < Dim; ++c)
        for (int d = 0; d < Dim; ++d) entry(a, b, c, d) = entry(b, a, d, c) = block(c, d);
    });
    clamp_to_semidefinite<Capacity>(K.data(), size);
    for_each_block<Dim>(hessian, [&](int a, int b, auto block) {
      for (int c = 0; c < Dim; ++c)
        for (int d = 0; d < Dim; ++d) block(c, d) = entry(a, b, c, d);
    });
  }
};

newton::Summary run(const DistortionProblem& problem, Vector& x, const MethodOptions& options,
                    const newton::IterationCallback& callback) {
  const Timer timer;
  return minimize_with(timer, std::make_unique<ElementProjection>(problem), problem, x, options, callback);
}

}  // namespace

std::vector<Method> element_projection() {
  return {
      {{"numerical_element", "numerical, per element", "6 x 6 and 12 x 12", Family::newton}, nullptr, run}};
}

}  // namespace isostretch::baselines
