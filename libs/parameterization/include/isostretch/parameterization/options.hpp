#pragma once

#include <isostretch/newton/options.hpp>
#include <isostretch/surface/cut.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace isostretch::parameterization {

using Point2 = Eigen::Vector2d;

/// A vertex that is held.
struct Pin {
  int vertex = -1;               ///< of the model, from 0
  std::optional<Point2> target;  ///< in output units; none: it stays where the start has it
};

/// A vertex that is drawn to a place, see newton::SoftPinTerm.
struct SoftPin {
  int vertex = -1;      ///< of the model, from 0
  Point2 target{0, 0};  ///< in output units
  double weight = 1;
};

/// Vertices that come to lie on a line along an axis.
struct AlignedVertices {
  std::vector<int> vertices;  ///< of the model, two or more
  bool horizontal = true;     ///< they share v; otherwise u
};

/// Where the minimisation starts: Tutte's embedding, or the model's texture coordinates.
enum class Initial { tutte, input };
/// The boundary of charts: free, fixed where the start has it, or held on a circle or square.
enum class Boundary { free, fixed, circle, square };
/// Charts side by side in a square, or where they are.
enum class Pack { automatic, square, none };
/// What is done about a chart that lies on itself.
enum class OverlapRule { automatic, split, allow };
/// What 1 is in the layout: the side of the unit square, a unit of the model, or the side of a square as
/// large as the surface.
enum class UvUnits { automatic, square, model, area };

/// How a surface is flattened. Nothing but a surface is needed: by default it is cut to disks where it is
/// none, started from Tutte's embedding, minimised, freed of overlap, and packed into the unit square.
struct Options {
  Initial initial = Initial::tutte;
  bool cut = true;                                  ///< false: what is not a disk is refused
  bool input_seams = true;                          ///< cut where the model's texture coordinates are
  mesh::Holes holes = mesh::Holes::keep_short;      ///< boundary loops that are no cut's business
  int cut_tips = mesh::CutOptions().max_terminals;  ///< ends of the cut of a closed surface of genus 0
  double max_distortion = 0;                        ///< cut further until within this factor; 0: no bound
  int max_cuts = 1000;                              ///< that max_distortion may add
  Boundary boundary = Boundary::free;
  std::vector<int> corners;  ///< of the square: four vertices of the model, or none
  Pack pack = Pack::automatic;
  double margin = 1.0 / 256;  ///< around packed charts, as a share of the square
  OverlapRule overlap = OverlapRule::automatic;
  UvUnits uv_units = UvUnits::automatic;
  std::vector<Pin> pins;
  std::vector<SoftPin> soft_pins;
  std::vector<AlignedVertices> aligned;
  newton::Options newton;  ///< its time_limit is that of all charts together

  /// Throws OptionError naming the first option that makes no sense, alone or beside others.
  void validate() const;

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

}  // namespace isostretch::parameterization
