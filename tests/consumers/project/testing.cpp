// check_energy on an energy written here: accepts a sound one, and finds the fault in the other.
#include "expect.hpp"

#include <isostretch/testing/check_energy.hpp>

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

int main() {
  const auto sound = isostretch::testing::check_energy(Own{});
  if (!sound.ok()) std::puts(sound.text().c_str());
  EXPECT(sound.ok());
  EXPECT(!isostretch::testing::check_energy(Wrong{}).ok());
}
