// check_energy on energies written here: accepts sound ones, and finds the fault in the last.
#include "expect.hpp"

#include <isostretch/testing/check_energy.hpp>

// snippet: docs/tutorials/energies.md
struct Yeoh {
  static constexpr const char* name = "yeoh";
  static constexpr double minimum_determinant = 0.0;  // a barrier
  double c1 = 0.5, c2 = -0.02, c3 = 0.03, K = 5.0;

  template <int Dim, class T>
  T psi(const isostretch::energies::Invariants<Dim, T>& I) const {
    using isostretch::pow;
    const T x = I.I2 * pow(I.I3, -2.0 / Dim) - double(Dim), v = I.I3 - 1.0;
    return x * (c1 + x * (c2 + x * c3)) + 0.5 * K * v * v;
  }
};
// end of snippet

struct Own {
  static constexpr const char* name = "own";
  template <int Dim, class T>
  T psi(const isostretch::energies::Invariants<Dim, T>& I) const {
    return I.I2 + 0.5 * (I.I3 - 2.0) * (I.I3 - 2.0);
  }
};

// Claims a barrier that it does not have.
struct Wrong : Own {
  static constexpr double minimum_determinant = 0.0;
};

template <class Energy>
static bool is_sound(const Energy& energy) {
  const auto report = isostretch::testing::check_energy(energy);
  if (!report.ok()) std::puts(report.text().c_str());
  return report.ok();
}

int main() {
  EXPECT(is_sound(Own{}));
  EXPECT(is_sound(Yeoh{}));
  EXPECT(!isostretch::testing::check_energy(Wrong{}).ok());
}
