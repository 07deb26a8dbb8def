// Projection of the whole Hessian of an element, 6 x 6 for triangles and 12 x 12 for tetrahedra, by a
// numerical eigen-decomposition: what most programs do, TinyAD for one.
#include "method_registry.hpp"
#include "modelled_energy_term.hpp"
#include "newton_driver.hpp"
#include "scaling_matrix.hpp"

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
      if (elements().dim == 2 && nodes() == 3)
        project<2, 6>(hessian_at(place));
      else if (elements().dim == 2)
        project<2, Eigen::Dynamic>(hessian_at(place));
      else if (nodes() == 4)
        project<3, 12>(hessian_at(place));
      else
        project<3, Eigen::Dynamic>(hessian_at(place));
    }
  }

  template <int Dim, int Size>
  void project(double* hessian) const {
    Eigen::Matrix<double, Size, Size> K(Dim * nodes(), Dim * nodes());
    for_each_block<Dim>(hessian, [&](int a, int b, const auto& block) {
      K.template block<Dim, Dim>(Dim * a, Dim * b) = block;
      K.template block<Dim, Dim>(Dim * b, Dim * a) = block.transpose();
    });
    K = nearest_semidefinite<Size>(K);
    for_each_block<Dim>(
        hessian, [&](int a, int b, auto block) { block = K.template block<Dim, Dim>(Dim * a, Dim * b); });
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
