#include "guess.hpp"

namespace isostretch::app::deform {

Guesser::Guesser(const Scene& scene, const Body& body, const Rig& rig)
    : rig_(rig), kind_(scene.guess), rest_(body.rest_positions()) {
  if (kind_ == Guess::harmonic || kind_ == Guess::biharmonic)
    spreader_.emplace(
        body.elements, rig.nodes(),
        kind_ == Guess::harmonic ? handles::SpreadKind::harmonic : handles::SpreadKind::biharmonic,
        scene.newton.solver);
}

Vector Guesser::guess(const Vector& positions, double from, double to, bool again) const {
  Vector x = kind_ == Guess::rest && !again ? rest_ : positions;
  if (spreader_) {
    Vector before = rest_, after = rest_;
    rig_.place_all(from, before);
    rig_.place_all(to, after);
    x += spreader_->spread(after - before);
  }
  rig_.place_hard(to, x);
  return x;
}

}  // namespace isostretch::app::deform
