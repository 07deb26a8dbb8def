// Projection of the Hessian over F at every quadrature point, 4 x 4 and 9 x 9, by a numerical
// eigen-decomposition. In exact arithmetic the same as the analytic one.
#include "method_registry.hpp"
#include "modelled_energy_term.hpp"
#include "newton_driver.hpp"
#include "scaling_matrix.hpp"

#include <isostretch/projection/projection.hpp>

#include <algorithm>
#include <array>
#include <memory>

namespace isostretch::baselines {
namespace {

class PointProjection final : public ModelledEnergyTerm {
 public:
  using ModelledEnergyTerm::ModelledEnergyTerm;

 private:
  static constexpr int batch = 64;  // elements whose exact Hessians are evaluated together

  void model(const Vector& x) override {
#pragma omp parallel for schedule(static)
    for (int first = 0; first < element_count(); first += batch) {
      const int count = std::min(batch, element_count() - first);
      for (int p = 0; p < elements().points_per_element; ++p)
        elements().dim == 2 ? add_point<2>(x, first, count, p) : add_point<3>(x, first, count, p);
    }
  }

  template <int Dim>
  void add_point(const Vector& x, int first, int count, int p) {
    constexpr int size = Dim * Dim, packed = size * (size + 1) / 2;
    std::array<double, size * batch> F;
    std::array<double, packed * batch> H;
    for (int i = 0; i < count; ++i) {
      const int element = element_at(first + i);
      const Eigen::Matrix<double, Dim, Dim> Fi = deformation_gradient<Dim>(x, point(element, p));
      for (int e = 0; e < size; ++e) F[static_cast<std::size_t>(e * batch + i)] = Fi.data()[e];
    }
    projection::HessianBatch task;
    task.F = F.data();
    task.H = H.data();
    task.count = static_cast<std::size_t>(count);
    task.stride = batch;
    projection::evaluate(energy(), Dim, {projection::Filter::none, 0.0, 0.0, nullptr}, task);
    for (int i = 0; i < count; ++i) add_projected<Dim>(H.data() + i, first + i, p);
  }

  // H: one point of the batch, `batch` apart.
  template <int Dim>
  void add_projected(const double* H, int place, int p) {
    constexpr int size = Dim * Dim;
    Eigen::Matrix<double, size, size> D;
    for (int i = 0; i < size; ++i)
      for (int j = i; j < size; ++j, H += batch) D(i, j) = D(j, i) = *H;
    D = nearest_semidefinite<size>(D);
    const std::size_t at = point(element_at(place), p);
    const auto g = rest_gradients<Dim>(at);
    const double weight = elements().weights[at];
    for_each_block<Dim>(hessian_at(place), [&](int a, int b, auto block) {
      if (p == 0) block.setZero();
      for (int c = 0; c < Dim; ++c)
        for (int d = 0; d < Dim; ++d)
          block += weight * g(c, a) * g(d, b) * D.template block<Dim, Dim>(Dim * c, Dim * d);
    });
  }
};

newton::Summary run(const DistortionProblem& problem, Vector& x, const MethodOptions& options,
                    const newton::IterationCallback& callback) {
  const Timer timer;
  return minimize_with(timer, std::make_unique<PointProjection>(problem), problem, x, options, callback);
}

}  // namespace

std::vector<Method> point_projection() {
  return {{{"numerical_point", "numerical, per quadrature point", "4 x 4 and 9 x 9", Family::newton},
           nullptr,
           run}};
}

}  // namespace isostretch::baselines
