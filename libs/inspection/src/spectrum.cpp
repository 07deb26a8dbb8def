#include <isostretch/inspection/spectrum.hpp>

#include <isostretch/invariants/stretch.hpp>
#include <isostretch/linalg/decompositions.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::inspection {
namespace {

constexpr std::size_t chunk_points = 64;

// The arrays of one chunk, for the energy to fill.
class Chunk {
 public:
  explicit Chunk(int dim) : dim_(dim) {
    for (auto* array : {&sigma_, &gradient_, &diagonal_, &twist_, &flip_, &coupling_})
      array->resize(3 * chunk_points);
    psi_.resize(chunk_points);
  }

  void fill(const std::vector<Stretches>& at, std::size_t first, std::size_t count) {
    for (std::size_t i = 0; i < chunk_points; ++i)
      for (std::size_t e = 0; e < static_cast<std::size_t>(dim_); ++e)
        sigma_[e * chunk_points + i] = i < count ? at[first + i][e] : 1;
  }

  void evaluate(const energies::AnyEnergy& energy) {
    energy.evaluate_derivatives(
        dim_, {static_cast<int>(chunk_points), chunk_points, sigma_.data(), psi_.data(), gradient_.data(),
               twist_.data(), flip_.data(), diagonal_.data(), coupling_.data()});
  }

  template <int Dim>
  Spectrum take(std::size_t point, const Stretches& at) const {
    constexpr int pairs = invariants::pair_count<Dim>;
    const auto entry = [&](const std::vector<double>& array, int e) {
      return array[static_cast<std::size_t>(e) * chunk_points + point];
    };
    Spectrum s;
    s.dim = Dim;
    s.at = at;
    s.psi = psi_[point];
    Eigen::Matrix<double, Dim, Dim> A;
    for (int e = 0; e < Dim; ++e) {
      s.stress[static_cast<std::size_t>(e)] = entry(gradient_, e);
      A(e, e) = entry(diagonal_, e);
    }
    for (int e = 0; e < pairs; ++e) {
      s.eigenvalues[0][static_cast<std::size_t>(e)] = entry(twist_, e);
      s.eigenvalues[1][static_cast<std::size_t>(e)] = entry(flip_, e);
      const int j = invariants::first<Dim>(e), k = invariants::second<Dim>(e);
      A(j, k) = A(k, j) = entry(coupling_, e);
    }
    s.diagonal = A(0, 0);
    s.coupling = A(0, 1);
    const auto scaling = linalg::symmetric_eigen<Dim>(A);
    std::copy(scaling.lambda.data(), scaling.lambda.data() + Dim, s.eigenvalues[2].begin());
    std::sort(s.eigenvalues[2].begin(), s.eigenvalues[2].begin() + Dim);
    return s;
  }

 private:
  int dim_;
  std::vector<double> sigma_, psi_, gradient_, diagonal_, twist_, flip_, coupling_;
};

}  // namespace

std::string mode_name(Mode mode) {
  return mode == Mode::twist ? "twist" : mode == Mode::flip ? "flip" : "scaling";
}

bool Spectrum::in_domain() const {
  return std::isfinite(psi) && std::isfinite(size());
}

double Spectrum::least(Mode mode) const {
  const auto& values = of(mode);
  return *std::min_element(values.begin(), values.begin() + count(mode));
}

double Spectrum::least() const {
  return std::min({least(Mode::twist), least(Mode::flip), least(Mode::scaling)});
}

double Spectrum::size() const {
  double largest = 0;
  for (const Mode mode : all_modes)
    for (int i = 0; i < count(mode); ++i) {
      const double magnitude = std::abs(of(mode)[static_cast<std::size_t>(i)]);
      if (!(magnitude <= largest)) largest = magnitude;  // NaN, too
    }
  return largest;
}

bool Spectrum::is_negative(Mode mode) const {
  return least(mode) < -rounding * size();
}

bool Spectrum::is_positive(Mode mode) const {
  return least(mode) > rounding * size();
}

std::vector<Spectrum> spectra(const energies::AnyEnergy& energy, int dim, const std::vector<Stretches>& at) {
  Chunk chunk(dim);
  std::vector<Spectrum> all;
  all.reserve(at.size());
  for (std::size_t first = 0; first < at.size(); first += chunk_points) {
    const std::size_t count = std::min(chunk_points, at.size() - first);
    chunk.fill(at, first, count);
    chunk.evaluate(energy);
    for (std::size_t i = 0; i < count; ++i)
      all.push_back(dim == 2 ? chunk.take<2>(i, at[first + i]) : chunk.take<3>(i, at[first + i]));
  }
  return all;
}

Spectrum spectrum(const energies::AnyEnergy& energy, int dim, const Stretches& at) {
  return spectra(energy, dim, {at}).front();
}

}  // namespace isostretch::inspection
