// An energy from text, at one stretch.
#include "expect.hpp"

#include <isostretch/expressions/expression.hpp>

#include <cmath>
#include <string>

int main() {
  using namespace isostretch;
  const auto energy = expressions::parse_energy("a/2*(I2 - d) - log(J)", {{"a", 2}});
  EXPECT(energy.has_barrier());
  const invariants::PrincipalStretches<2, double> stretch{{2.0, 0.5}};
  EXPECT(std::abs(energies::derivatives_at(energy, stretch).psi - 2.25) < 1e-14);
  std::string message;
  try {
    expressions::parse_energy("I2 - b");
  } catch (const Error& error) {
    message = error.what();
  }
  EXPECT(message.find("'b'") != std::string::npos);
}
