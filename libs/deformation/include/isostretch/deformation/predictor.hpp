#pragma once

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/deformation/handle_set.hpp>
#include <isostretch/handles/spread.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace isostretch::deformation {

/// Where the minimisation of a frame starts from.
enum class InitialGuess {
  rest,        ///< the rest shape with the handles moved
  previous,    ///< the frame before with the handles moved
  harmonic,    ///< the frame before, and the further way of the handles spread over the body
  biharmonic,  ///< the same, smoother at the handles
};
inline constexpr ChoiceNames<InitialGuess, 4> initial_guess_names{{{"rest", InitialGuess::rest},
                                                                   {"previous", InitialGuess::previous},
                                                                   {"harmonic", InitialGuess::harmonic},
                                                                   {"biharmonic", InitialGuess::biharmonic}}};

using Warn = std::function<void(const std::string&)>;

/// Starts of minimisations; hard handles are in their places to the bit.
class Predictor {
 public:
  /// A guess is only a guess: where the way of the handles cannot be spread as asked, it is spread in
  /// a simpler way or not at all, and `warn` is told so once.
  Predictor(InitialGuess kind, const SolidModel& body, const HandleSet& handle_set, Warn warn);

  /// `positions` solve the problem at time `from`. `again`: the guess of the whole step was outside the
  /// domain of the energy, and the step is taken in parts, for which the rest shape is no start.
  Vector guess(const Vector& positions, double from, double to, bool again);

 private:
  /// One to spread displacements.
  struct Way {
    std::string name;
    handles::SpreadKind kind;
    sparse::Options solver;
    std::optional<handles::Spreader> spreader = {};
    bool hopeless = false, warned = false;
  };

  void choose_ways();
  bool prepare(std::size_t way);
  Vector spread(const Vector& displacement);
  void warn_of(std::size_t way, const std::string& what);

  const SolidModel& body_;
  const HandleSet& handle_set_;
  InitialGuess kind_;
  Vector rest_;
  Warn warn_;
  std::vector<Way> ways_;  ///< the best first
};

}  // namespace isostretch::deformation
