#pragma once

#include <isostretch/newton/options.hpp>

namespace isostretch::deformation {

/// Where the minimisation of a frame between two shapes starts from.
enum class Continuation {
  previous,     ///< the frame before
  extrapolate,  ///< that, or of several continuations of the frames so far the one of least energy
};
/// Returns the names of the starts in scenes.
constexpr ChoiceNames<Continuation, 2> choice_names(Continuation) {
  return {{{"previous", Continuation::previous}, {"extrapolate", Continuation::extrapolate}}};
}

/// Returns the options of newton that suit frames between two shapes.
///
/// Frames end as soon as a full step gains less than a millionth of the energy: what is left then is far
/// below what can be seen, and to prove more takes a factorization that moves nothing. One or two
/// factorizations a frame do not repay the time for nested dissection; and since starts are good nearly
/// everywhere, the Hessian is filtered only where they are not, which takes fewer of them than other
/// projections.
inline newton::Options frame_solver() {
  newton::Options options;
  options.relative_energy_tolerance = 1e-6;
  options.projection = newton::Projection::progressive;
  options.solver.ordering = sparse::Ordering::amd;
  return options;
}

/// How shapes between two are made.
struct InterpolationOptions {
  int frames = 10;  ///< after the first shape; the last is the second shape
  /// Where the minimisation of a frame starts from.
  Continuation guess = Continuation::extrapolate;
  /// Options of the solve of a frame; the limit of time is that of all frames together.
  newton::Options newton = frame_solver();

  /// Visits (Field, member) for each option, see core/option_fields.hpp.
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit(Field{"frames", "Number of steps from the first shape to the second", between(1, 1e6)},
          self.frames);
    visit(Field{"initial_guess", "Shape that the solver starts every frame from"}, self.guess);
    visit(Field{"newton", "How the energy is minimised"}, self.newton);
  }

  /// Returns the time of a frame, from 0 to 1, both exact.
  double time(int frame) const { return static_cast<double>(frame) / frames; }
};

}  // namespace isostretch::deformation
