#pragma once

#include <isostretch/newton/options.hpp>
#include <isostretch/surface/cut.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace isostretch::parameterization {

/// A place in the layout.
using Point2 = Eigen::Vector2d;

/// A vertex that is held.
struct Pin {
  int vertex = -1;               ///< The vertex of the model, from 0.
  std::optional<Point2> target;  ///< in output units; none: it stays where the start has it
};

/// A vertex that is drawn to a place, see newton::SoftPinTerm.
struct SoftPin {
  int vertex = -1;      ///< The vertex of the model, from 0.
  Point2 target{0, 0};  ///< in output units
  double weight = 1;    ///< The weight of the pull.
};

/// Vertices that come to lie on a line along an axis.
struct AlignedVertices {
  std::vector<int> vertices;  ///< Two or more vertices of the model.
  bool horizontal = true;     ///< they share v; otherwise u
};

/// Where the minimisation starts: Tutte's embedding, or the model's texture coordinates.
enum class Initial { tutte, input };
/// Returns the names of the choices on command lines and in scenes.
constexpr ChoiceNames<Initial, 2> choice_names(Initial) {
  return {{{"tutte", Initial::tutte}, {"input", Initial::input}}};
}
/// The boundary of charts: free, fixed where the start has it, or held on a circle or square.
enum class Boundary { free, fixed, circle, square };
/// Returns the names of the choices on command lines and in scenes.
constexpr ChoiceNames<Boundary, 4> choice_names(Boundary) {
  return {{{"free", Boundary::free},
           {"fixed", Boundary::fixed},
           {"circle", Boundary::circle},
           {"square", Boundary::square}}};
}
/// Charts side by side in a square, or where they are.
enum class Pack { automatic, square, none };
/// Returns the names of the choices on command lines and in scenes.
constexpr ChoiceNames<Pack, 3> choice_names(Pack) {
  return {{{"auto", Pack::automatic}, {"square", Pack::square}, {"none", Pack::none}}};
}
/// The ways to treat a chart that lies on itself.
enum class OverlapRule { automatic, split, allow };
/// Returns the names of the choices on command lines and in scenes.
constexpr ChoiceNames<OverlapRule, 3> choice_names(OverlapRule) {
  return {{{"auto", OverlapRule::automatic}, {"split", OverlapRule::split}, {"allow", OverlapRule::allow}}};
}
/// The units of the layout: the side of the unit square, a unit of the model, or the side of a square as
/// large as the surface.
enum class UvUnits { automatic, square, model, area };
/// Returns the names of the choices on command lines and in scenes.
constexpr ChoiceNames<UvUnits, 4> choice_names(UvUnits) {
  return {{{"auto", UvUnits::automatic},
           {"square", UvUnits::square},
           {"model", UvUnits::model},
           {"area", UvUnits::area}}};
}

/// How a surface is flattened. Nothing but a surface is needed: by default it is cut to disks where it is
/// none, started from Tutte's embedding, minimised, freed of overlap, and packed into the unit square.
struct Options {
  Initial initial = Initial::tutte;                 ///< Where the minimisation starts.
  bool cut = true;                                  ///< false: what is not a disk is refused
  bool input_seams = true;                          ///< cut where the model's texture coordinates are
  mesh::Holes holes = mesh::Holes::keep_short;      ///< boundary loops that are no cut's business
  int cut_tips = mesh::CutOptions().max_terminals;  ///< ends of the cut of a closed surface of genus 0
  double max_distortion = 0;                        ///< cut further until within this factor; 0: no bound
  int max_cuts = 1000;                              ///< that max_distortion may add
  Boundary boundary = Boundary::free;               ///< How the boundary of charts is held.
  std::vector<int> corners;     ///< Four vertices of the model at the corners of the square, or none.
  Pack pack = Pack::automatic;  ///< Whether charts are laid side by side.
  double margin = 1.0 / 256;    ///< around packed charts, as a share of the square
  OverlapRule overlap = OverlapRule::automatic;  ///< How a chart that lies on itself is treated.
  UvUnits uv_units = UvUnits::automatic;         ///< The unit of the layout.
  std::vector<Pin> pins;                         ///< Vertices that are held.
  std::vector<SoftPin> soft_pins;                ///< Vertices that are drawn to places.
  std::vector<AlignedVertices> aligned;          ///< Vertices that come to lie on lines.
  newton::Options newton;                        ///< its time_limit is that of all charts together

  /// Visits (Field, member) for each option that is a number or a choice, see core/option_fields.hpp.
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit);

  /// Throws OptionError naming the first option that makes no sense, alone or beside others.
  void validate() const;

  /// Returns whether a vertex is held or drawn to a place.
  bool has_pins() const { return !pins.empty() || !soft_pins.empty(); }
  /// Returns whether so many charts are laid side by side into a square.
  bool packs(std::size_t charts) const;
  /// Returns whether charts that lie on themselves are divided, of so many. Parts that are not packed would
  /// stay where they are, and vertices that are aligned could come into different parts.
  bool splits_overlap(std::size_t charts) const;
  /// Returns whether the cut of a closed surface goes on to what comes out distorted.
  bool reaches_tips() const;
  /// Returns what automatic units are. Places that the user gives are in units of the model.
  UvUnits units() const;
};

template <class Self, class Visit>
void Options::fields(Self& self, Visit&& visit) {
  visit(Field{"cut", "Cut what is not a disk open, instead of refusing it"}, self.cut);
  visit(Field{"input_seams", "Cut where the texture coordinates of the model are cut"}, self.input_seams);
  visit(Field{"holes",
              "Boundary loops inside that are kept as holes, not cut to: those that are short, none, all"},
        self.holes);
  visit(
      Field{"cut_tips", "Ends of the cut that opens a closed surface of genus 0, at most", between(2, 1000)},
      self.cut_tips);
  visit(
      Field{"max_distortion",
            "Cut further until no length is stretched or shrunk by more than this factor, above 1; 0: never",
            at_least(0)},
      self.max_distortion);
  visit(Field{"max_cuts", "Cuts that max_distortion may add", between(0, 1e6)}, self.max_cuts);
  visit(Field{"boundary", "Free; fixed where the start has it; held on a circle or square"}, self.boundary);
  visit(
      Field{"pack",
            "square: charts side by side in a square; none: where they are; auto: square, but none when the "
            "start is the uv of the model or one chart has pins"},
      self.pack);
  visit(Field{"overlap",
              "What to do about a chart that lies on itself: split it and pack the parts, or allow it; auto: "
              "split when charts are packed, unless nothing may be cut"},
        self.overlap);
  visit(Field{"uv_units",
              "square: uv from 0 to 1; model: lengths as on the model; area: total area 1; auto: square, but "
              "model with pins"},
        self.uv_units);
  visit(Field{"margin", "Space around packed charts, as a share of the square", between(0, 0.25)},
        self.margin);
  visit(Field{"initial", "Start from Tutte's embedding, or from the uv of the model"}, self.initial);
  visit(Field{"newton", "How the energy is minimised"}, self.newton);
}

}  // namespace isostretch::parameterization
