#pragma once

#include "common/deformation_names.hpp"

#include "options.hpp"
#include "spectrum.hpp"

#include <isostretch/expressions/printout.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace isostretch::app::inspect {

// What rest is to the energy, as far as second derivatives tell.
enum class RestKind {
  minimum,     // but for rotations, which change nothing
  degenerate,  // some other change of shape costs nothing to second order
  saddle,
  stressed,
  outside  // of the domain
};
inline constexpr ChoiceNames<RestKind, 5> rest_names{{{"minimum", RestKind::minimum},
                                                      {"degenerate", RestKind::degenerate},
                                                      {"saddle", RestKind::saddle},
                                                      {"stressed", RestKind::stressed},
                                                      {"outside", RestKind::outside}}};

struct Rest {
  Spectrum spectrum;
  RestKind kind;

  bool stress_free() const { return kind != RestKind::stressed && kind != RestKind::outside; }
  // Small-strain Lame parameters; tangent moduli where it is not free of stress.
  double mu() const { return 0.5 * spectrum.of(Mode::flip)[0]; }
  double lambda() const { return spectrum.coupling; }
};

// One of the stretches to show.
struct Example {
  std::string kind;  // uniform, uniaxial, ...
  Spectrum spectrum;
};

// Of one mode over all samples.
struct ModeRecord {
  long negative = 0;  // samples
  Spectrum worst;     // of the least eigenvalue of the mode
};

// Over a logarithmic grid of stretches s1 >= s2 >= s3 in the range.
struct Sample {
  long count = 0;    // in the domain
  long outside = 0;  // of the domain
  std::array<ModeRecord, 3> modes;

  const ModeRecord& of(Mode mode) const { return modes[static_cast<std::size_t>(mode)]; }
  double share(Mode mode) const {
    return count > 0 ? static_cast<double>(of(mode).negative) / static_cast<double>(count) : 0;
  }
};

// Where the Hessian is positive semi-definite, within the range.
struct Convexity {
  std::optional<Range> uniform;  // stretches (s, s[, s]) around 1; nothing: not at 1
  // The largest r so that it is for all stretches in [1/r, r], and so that its flips and scalings are.
  // 1: in no neighbourhood of rest.
  double box = 1, box_without_twist = 1;
  double largest_box = 1;  // that the range has room for
};

// An energy in one dimension.
struct Study {
  int dim;
  Rest rest;
  std::vector<Example> examples;
  Sample sample;
  Convexity convexity;
  std::vector<expressions::Formula> formulas;  // of expressions
};

Study study(const energies::AnyEnergy& energy, int dim, const Options& options);

}  // namespace isostretch::app::inspect
