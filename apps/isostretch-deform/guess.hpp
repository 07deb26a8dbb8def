#pragma once

#include "rig.hpp"

#include <isostretch/handles/spread.hpp>

#include <optional>

namespace isostretch::app::deform {

// Starts of minimisations; hard handles are in their places to the bit.
class Guesser {
 public:
  Guesser(const Scene& scene, const Body& body, const Rig& rig);

  // `positions` solve the problem at time `from`. `again`: the guess of the whole step was outside the domain
  // of the energy, and the step is taken in parts, for which the rest shape is no start.
  Vector guess(const Vector& positions, double from, double to, bool again) const;

 private:
  const Rig& rig_;
  Guess kind_;
  Vector rest_;
  std::optional<handles::Spreader> spreader_;
};

}  // namespace isostretch::app::deform
