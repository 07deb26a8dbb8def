#pragma once

#include <isostretch/deformation/handle_script.hpp>
#include <isostretch/deformation/predictor.hpp>
#include <isostretch/energies/any_energy.hpp>
#include <isostretch/handles/selection.hpp>
#include <isostretch/newton/options.hpp>

#include <optional>
#include <string>
#include <vector>

namespace isostretch::deformation {

/// Elements with an energy of their own.
struct RegionSpec {
  std::string path;                          ///< for messages, such as "regions[0]"
  std::string name;                          ///< Shown in reports.
  std::optional<handles::Selection> select;  ///< elements all of whose nodes are in it
  std::vector<int> elements;                 ///< otherwise these
  energies::AnyEnergy energy;                ///< The energy of these elements.
};

/// How a body is deformed, frame by frame: what moves, and what it is made of.
struct SequenceOptions {
  energies::AnyEnergy energy;            ///< The energy of elements that are in no region.
  std::vector<RegionSpec> regions = {};  ///< the first that has an element keeps it
  HandleScript script = {};              ///< Handles, how they move, and the number of frames.
  /// Where the minimisation of a frame starts from.
  InitialGuess guess = InitialGuess::biharmonic;
  /// Options of the solve of a frame; time_limit is that of all frames together.
  newton::Options newton = {};

  /// Visits (Field, member) for each option that is a number or a choice, see core/option_fields.hpp.
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit(Field{"initial_guess", "Shape that the solver starts every frame from"}, self.guess);
    visit(Field{"newton", "How the energy is minimised"}, self.newton);
  }
};

}  // namespace isostretch::deformation
