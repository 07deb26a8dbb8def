#pragma once

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/deformation/handle_set.hpp>
#include <isostretch/handles/extension.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace isostretch::deformation {

/// The shapes from which the minimisation of a frame can start.
enum class InitialGuess {
  rest,      ///< The rest shape with the handles moved.
  previous,  ///< The frame before with the handles moved.
  harmonic,  ///< The frame before plus the harmonic extension of the handles' further displacement.
  /// The frame before plus the biharmonic extension of the handles' further displacement: smoother at the
  /// handles.
  biharmonic,
};
/// Returns the names of initial guesses in scenes and on the command line.
constexpr ChoiceNames<InitialGuess, 4> choice_names(InitialGuess) {
  return {{{"rest", InitialGuess::rest},
           {"previous", InitialGuess::previous},
           {"harmonic", InitialGuess::harmonic},
           {"biharmonic", InitialGuess::biharmonic}}};
}

/// A function that takes warnings for the user.
using Warn = std::function<void(const std::string&)>;

/// A maker of initial guesses, with hard handles in their places to the bit.
class Predictor {
 public:
  /// Prepares guesses of a kind. Where the displacement of the handles cannot be extended as asked, it is
  /// extended in a simpler way or not at all, and `warn` is told so once. Body and handle set must outlive
  /// this object.
  Predictor(InitialGuess kind, const SolidModel& body, const HandleSet& handle_set, Warn warn);

  /// Returns an initial guess at time `to`. `positions` solve the problem at time `from`. `again` says that
  /// the guess of the whole step was outside the domain of the energy, and the step is taken in parts, for
  /// which the rest shape is no start.
  Vector guess(const Vector& positions, double from, double to, bool again);

 private:
  /// A method of extending displacements to all nodes.
  struct Method {
    std::string name;
    handles::ExtensionKind kind;
    sparse::Options solver;
    std::optional<handles::Extension> extension = {};
    bool hopeless = false, warned = false;
  };

  void choose_methods();
  bool prepare(std::size_t method);
  Vector extend(const Vector& displacement);
  void warn_of(std::size_t method, const std::string& what);

  const SolidModel& body_;
  const HandleSet& handle_set_;
  InitialGuess kind_;
  Vector rest_;
  Warn warn_;
  std::vector<Method> methods_;  ///< The best first.
};

}  // namespace isostretch::deformation
