// Anderson-accelerated local-global (Peng, Deng, Zhang, Geng, Qin, Liu 2018): with the map G of LocalGlobal
// and residuals f_k = G(x_k) - x_k,
//
//   x_next = G(x_k) - sum_j theta_j (G(x_{k-j+1}) - G(x_{k-j})),
//   theta  = argmin |f_k - sum_j theta_j (f_{k-j+1} - f_{k-j})|^2,  j = 1 ... at most 5,
//
// where that lowers the energy, and G(x_k) where it does not; the history is kept then.
//
// Deviation: the small least-squares problem is solved by its normal equations with columns of unit length,
// in the directions of their matrix that stand out of rounding.
#include "local_global.hpp"
#include "method_registry.hpp"

#include <isostretch/linalg/symmetric_eigen_ql.hpp>

#include <array>
#include <cstddef>
#include <deque>
#include <numeric>
#include <utility>

namespace isostretch::baselines {
namespace {

constexpr std::size_t window = 5;
constexpr double rounding = 1e-15;  // of the eigenvalues of a matrix with ones on its diagonal

class Anderson final : public FirstOrderMethod {
 public:
  explicit Anderson(const DistortionProblem& problem) : map_(problem) {}

  Step step(const Iterate& at, SharedPieces& pieces) override {
    Vector image;
    map_.apply(at.x, pieces, image);
    const Vector residual = image - at.x;
    remember(image, residual);
    Vector accelerated = image;
    if (!differences_.empty()) accelerated -= combination(residual);
    const bool lower = !differences_.empty() && pieces.value(accelerated) < at.energy;
    Step step = full_step_to(at, image);
    if (lower) step.x.swap(accelerated);
    step.row.evaluations = differences_.empty() ? 0 : 1;
    return step;
  }

 private:
  struct Difference {
    Vector image, residual;
  };

  void remember(const Vector& image, const Vector& residual) {
    // A difference of nothing says nothing.
    if (last_image_.size() > 0 && residual != last_residual_) {
      differences_.push_front({image - last_image_, residual - last_residual_});
      if (differences_.size() > window) differences_.pop_back();
    }
    last_image_ = image;
    last_residual_ = residual;
  }

  // sum_j theta_j (difference of images)_j.
  Vector combination(const Vector& residual) const {
    const std::size_t size = differences_.size();
    std::array<double, window * window> normal;
    std::array<double, window> right, length, theta{};
    for (std::size_t i = 0; i < size; ++i) {
      length[i] = differences_[i].residual.norm();
      right[i] = differences_[i].residual.dot(residual) / length[i];
      for (std::size_t j = 0; j <= i; ++j)
        normal[i * size + j] = normal[j * size + i] =
            differences_[i].residual.dot(differences_[j].residual) / (length[i] * length[j]);
    }
    const linalg::SymmetricEigenQl<window> eigen(normal.data(), static_cast<int>(size));
    // Nothing is combined of what is not finite.
    for (int k = 0; eigen.converged() && k < static_cast<int>(size); ++k) {
      if (eigen.value(k) <= rounding) continue;
      const double* v = eigen.vector(k);
      const double along = std::inner_product(v, v + size, right.begin(), 0.0) / eigen.value(k);
      for (std::size_t i = 0; i < size; ++i) theta[i] += along * v[i];
    }
    Vector sum = Vector::Zero(residual.size());
    for (std::size_t i = 0; i < size; ++i) sum += theta[i] / length[i] * differences_[i].image;
    return sum;
  }

  LocalGlobal map_;
  std::deque<Difference> differences_;  // newest first
  Vector last_image_, last_residual_;
};

newton::Summary run(const DistortionProblem& problem, Vector& x, const MethodOptions& options,
                    const newton::IterationCallback& callback) {
  Anderson method(problem);
  return minimize_first_order(method, problem, x, options, callback);
}

}  // namespace

std::vector<Method> anderson_methods() {
  return {{{"anderson", "Anderson-accelerated local-global", "Peng et al. 2018", Family::constant_metric},
           why_not_local_global,
           run}};
}

}  // namespace isostretch::baselines
