// What an energy does: rest, and the signs of its eigenvalues.
#include "expect.hpp"

#include <isostretch/energies/registry.hpp>
#include <isostretch/inspection/findings.hpp>

using namespace isostretch;

int main() {
  // snippet: libs/inspection/README.md
  const energies::AnyEnergy energy = energies::make_energy("symmetric_dirichlet");
  const inspection::Study study = inspection::study(energy, energy.name(), 3, {0.5, 2});
  const bool minimum = study.rest.kind == inspection::RestKind::minimum;
  const double twists = study.sample.share(inspection::Mode::twist);  // of the stretches from 0.5 to 2
  const double box = study.convexity.box;  // positive semi-definite for all stretches in [1 / box, box]
  // end of snippet
  EXPECT(minimum);
  EXPECT(twists >= 0 && twists < 1);
  EXPECT(box >= 1 && box <= 2);
}
