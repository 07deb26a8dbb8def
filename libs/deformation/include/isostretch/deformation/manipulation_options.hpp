#pragma once

#include <isostretch/deformation/handle_script.hpp>
#include <isostretch/handles/rotation_blend.hpp>
#include <isostretch/sdp_penalty/options.hpp>

#include <limits>

namespace isostretch::deformation {

/// Where the elements' ex-rotations come from.
enum class Rotations {
  biharmonic,  ///< those of the handles, blended by bounded biharmonic weights
  none         ///< the identity everywhere
};
/// Returns the names of the choices in scenes.
constexpr ChoiceNames<Rotations, 2> choice_names(Rotations) {
  return {{{"biharmonic", Rotations::biharmonic}, {"none", Rotations::none}}};
}

/// The weights of elements in the elastic energy: their volume (area), or 1.
enum class ElementWeights { volume, unit };
/// Returns the names of the choices in scenes.
constexpr ChoiceNames<ElementWeights, 2> choice_names(ElementWeights) {
  return {{{"volume", ElementWeights::volume}, {"unit", ElementWeights::unit}}};
}

/// The units of length in the term of the soft handles: the diagonal of the body at rest, or that of the
/// mesh.
enum class LengthUnit { diagonal, mesh };
/// Returns the names of the choices in scenes.
constexpr ChoiceNames<LengthUnit, 2> choice_names(LengthUnit) {
  return {{{"diagonal", LengthUnit::diagonal}, {"mesh", LengthUnit::mesh}}};
}

/// How a body is manipulated without inverting an element (Liu et al. 2016); see sdp_penalty::Problem for
/// alpha, incompressibility, margin and largest_stretch.
struct ManipulationOptions {
  HandleScript script = {};                         ///< Handles, how they move, and the number of frames.
  double alpha = 1e4;                               ///< Weight of the soft handles.
  ElementWeights weights = ElementWeights::volume;  ///< How much an element counts.
  LengthUnit units = LengthUnit::diagonal;          ///< Unit of length in the term of the soft handles.
  double incompressibility = 0;                     ///< Weight kappa of the term that keeps volume.
  double margin = 0;                                ///< Lower bound on the eigenvalues of S.
  /// Upper bound on the singular values of F.
  double largest_stretch = std::numeric_limits<double>::infinity();
  /// Rounds with the rotations of the round before, after that with the given ones.
  int relinearize = 0;
  Rotations rotations = Rotations::biharmonic;                   ///< Where the ex-rotations come from.
  handles::RotationBlend blend = handles::RotationBlend::angle;  ///< How rotations of handles are blended.
  sdp_penalty::Options solver = {};                              ///< Options of the convex problem.

  /// Visits (Field, member) for each option but the handles, those of the solver among them, see
  /// core/option_fields.hpp.
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit(Field{"alpha",
                "Weight of the soft handles against the distortion: more brings them closer to their targets",
                above(0)},
          self.alpha);
    visit(Field{"element_weights", "How much an element counts: its volume, or all the same"}, self.weights);
    visit(
        Field{
            "length_unit",
            "Weigh handles by shares of the diagonal of the mesh, or by its lengths as published scenes do"},
        self.units);
    visit(Field{"incompressibility",
                "Weight of the term that keeps volume (kappa): above 0 for bodies like rubber or flesh",
                at_least(0)},
          self.incompressibility);
    visit(Field{"margin",
                "Keep lengths from shrinking below about this share (the least eigenvalue of S), against "
                "elements that are all but flat",
                below_highest(between(0, 1))},
          self.margin);
    visit(
        Field{"largest_stretch",
              "Forbid that a length grows by more than this factor; for the method interior_point", above(1)},
        self.largest_stretch);
    visit(Field{"relinearize",
                "Solve again up to so many times, with the rotations of the result before, for shapes that "
                "bend more naturally",
                between(0, 1e6)},
          self.relinearize);
    visit(Field{"rotations",
                "Rotations that elements are to follow: blended smoothly from those of the handles, or none"},
          self.rotations);
    visit(Field{"blend",
                "How rotations of handles are blended; by default angle in the plane, else quaternion"},
          self.blend);
    sdp_penalty::Options::fields(self.solver, visit);
  }
};

}  // namespace isostretch::deformation
