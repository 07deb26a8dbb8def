#pragma once

#include <isostretch/core/choice_names.hpp>
#include <isostretch/expressions/printout.hpp>
#include <isostretch/inspection/spectrum.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace isostretch::inspection {

/// A range of stretches around 1.
struct StretchRange {
  /// Least stretch, below 1.
  double low = 0.3, high = 3;  ///< Largest stretch, above 1.
};

/// The place of rest among the states of an energy, as far as second derivatives tell.
enum class RestKind {
  minimum,     ///< Least but for rotations, which change nothing.
  degenerate,  ///< Some other change of shape costs nothing to second order.
  saddle,      ///< The Hessian has negative eigenvalues.
  stressed,    ///< Rest is not free of stress.
  outside      ///< Rest is outside of the domain.
};
/// The names of the enumerators.
inline constexpr ChoiceNames<RestKind, 5> rest_names{{{"minimum", RestKind::minimum},
                                                      {"degenerate", RestKind::degenerate},
                                                      {"saddle", RestKind::saddle},
                                                      {"stressed", RestKind::stressed},
                                                      {"outside", RestKind::outside}}};

/// The energy at rest.
struct Rest {
  Spectrum spectrum;  ///< Spectrum at rest.
  RestKind kind;      ///< Place of rest among the states.

  /// Returns whether rest is free of stress.
  bool stress_free() const { return kind != RestKind::stressed && kind != RestKind::outside; }
  /// Returns the small-strain Lame parameter mu, a tangent modulus where rest is not free of stress.
  double mu() const { return 0.5 * spectrum.of(Mode::flip)[0]; }
  /// Returns the small-strain Lame parameter lambda, a tangent modulus where rest is not free of stress.
  double lambda() const { return spectrum.coupling; }
};

/// One of the stretches to show.
struct Example {
  std::string kind;   ///< Kind of the stretch: uniform, uniaxial, shear and so on.
  Spectrum spectrum;  ///< Spectrum there.
};

/// A mode over all samples.
struct ModeRecord {
  long negative = 0;  ///< Samples with a negative eigenvalue of the mode.
  Spectrum worst;     ///< Spectrum with the least eigenvalue of the mode.
};

/// The energy on a logarithmic grid of stretches s1 >= s2 >= s3 in the range.
struct Sample {
  long count = 0;                   ///< Samples in the domain.
  long outside = 0;                 ///< Samples outside of it.
  std::array<ModeRecord, 3> modes;  ///< Records by mode.

  /// Returns the record of a mode.
  const ModeRecord& of(Mode mode) const { return modes[static_cast<std::size_t>(mode)]; }
  /// Returns the share of the samples in the domain at which the mode has a negative eigenvalue.
  double share(Mode mode) const {
    return count > 0 ? static_cast<double>(of(mode).negative) / static_cast<double>(count) : 0;
  }
};

/// Where the Hessian is positive semi-definite, within the range.
struct Convexity {
  std::optional<StretchRange> uniform;  ///< Stretches (s, s[, s]) around 1 at which it is; none: not at 1.
  double box = 1;  ///< Largest r so that it is for all stretches in [1/r, r]; 1: in no neighbourhood of rest.
  double box_without_twist = 1;  ///< Largest such r for flips and scalings alone.
  double largest_box = 1;        ///< Largest r that the range has room for.
};

/// The findings about an energy in one dimension.
struct Study {
  int dim;                                     ///< Dimension, 2 or 3.
  Rest rest;                                   ///< The energy at rest.
  std::vector<Example> examples;               ///< Stretches of several kinds.
  Sample sample;                               ///< Signs of eigenvalues all over the range.
  Convexity convexity;                         ///< Where the Hessian is positive semi-definite.
  std::vector<expressions::Formula> formulas;  ///< Derivatives, of expressions.
};

/// Studies an energy in one dimension, which it must exist in. `source` is its name or expression; formulas
/// are those of an expression.
Study study(const energies::AnyEnergy& energy, const std::string& source, int dim, const StretchRange& range);

}  // namespace isostretch::inspection
