// psi of a built-in energy, and of one written here, at the stretches of eight points.
#include "expect.hpp"

#include <isostretch/energies/registry.hpp>

#include <cmath>
#include <vector>

struct Squared {
  static constexpr const char* name = "squared";
  template <int Dim, class T>
  T psi(const isostretch::energies::Invariants<Dim, T>& I) const {
    return I.I2 * I.I2;
  }
};

static std::vector<double> psi_of(const isostretch::energies::AnyEnergy& energy, std::vector<double> sigma) {
  std::vector<double> psi(8);
  isostretch::energies::StretchChunk chunk;
  chunk.count = 8;
  chunk.stride = 8;
  chunk.sigma = sigma.data();
  chunk.psi = psi.data();
  energy.evaluate_psi(2, chunk);
  return psi;
}

int main() {
  std::vector<double> sigma(16);
  for (std::size_t i = 0; i < 8; ++i) {
    sigma[i] = 1.0 + 0.1 * static_cast<double>(i);
    sigma[8 + i] = 1.0;
  }
  const auto energy = isostretch::energies::make_energy("symmetric_dirichlet", {{"weight", 0.5}});
  const auto builtin = psi_of(energy, sigma), own = psi_of(Squared{}, sigma);
  for (std::size_t i = 0; i < 8; ++i) {
    const double a = sigma[i] * sigma[i];
    EXPECT(std::abs(builtin[i] - builtin[0] - 0.5 * (a + 1 / a - 2)) < 1e-13);
    EXPECT(std::abs(own[i] - (a + 1) * (a + 1)) < 1e-13);
  }
  sigma[8] = -1.0;
  EXPECT(std::isinf(psi_of(energy, sigma)[0]));
}
