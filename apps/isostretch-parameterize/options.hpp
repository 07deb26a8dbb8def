#pragma once

#include <isostretch/newton/options.hpp>
#include <isostretch/surface/cut.hpp>

#include <Eigen/Core>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isostretch::app::parameterize {

using Point2 = Eigen::Vector2d;

struct Pin {
  int vertex = -1;               // of the input, from 0
  std::optional<Point2> target;  // in output units; none: stays where the start has it
};

struct SoftPin {
  int vertex = -1;
  Point2 target{0, 0};  // in output units
  double weight = 1;
};

struct AlignedVertices {
  std::vector<int> vertices;  // of the input
  bool horizontal = true;     // they share v; otherwise u
};

enum class Initial { tutte, input };
enum class Boundary { free, fixed, circle, square };
enum class Pack { automatic, square, none };
enum class OverlapRule { automatic, split, allow };
// One side of the unit square, one unit of the model, or the side of a square as large as the surface.
enum class UvUnits { automatic, square, model, area };

struct Options {
  std::filesystem::path model;
  std::filesystem::path out;
  Initial initial = Initial::tutte;
  bool check = false;  // only say what is wrong with the model
  bool repair = false;
  std::optional<double> weld;  // tolerance
  bool cut = true;
  bool input_seams = true;  // cut where the input's uv does
  mesh::Holes holes = mesh::Holes::keep_short;
  int cut_tips = mesh::CutOptions().max_terminals;
  double max_distortion = 0;  // 0: no bound
  int max_cuts = 1000;        // for that bound
  Boundary boundary = Boundary::free;
  std::vector<int> corners;  // of the square, vertices of the input
  Pack pack = Pack::automatic;
  double margin = 1.0 / 256;
  OverlapRule overlap = OverlapRule::automatic;
  UvUnits uv_units = UvUnits::automatic;
  bool picture = true;
  bool glb = false;
  std::vector<Pin> pins;
  std::vector<SoftPin> soft_pins;
  std::vector<AlignedVertices> aligned;
  newton::Options newton;

  bool has_pins() const { return !pins.empty() || !soft_pins.empty(); }
  // Whether so many charts are laid side by side into a square.
  bool packs(std::size_t charts) const {
    if (pack != Pack::automatic) return pack == Pack::square;
    if (overlap == OverlapRule::split) return true;
    return initial != Initial::input && (charts > 1 || !has_pins());
  }
  // Whether charts that lie on themselves are divided. Parts that are not packed would stay where they are,
  // and vertices that are aligned could come into different parts.
  bool splits_overlap(std::size_t charts) const {
    if (overlap != OverlapRule::automatic) return overlap == OverlapRule::split;
    return cut && aligned.empty() && packs(charts);
  }
  // Whether the cut of a closed surface goes on to what comes out distorted.
  bool reaches_tips() const {
    return cut && cut_tips > 2 && initial == Initial::tutte && boundary == Boundary::free && !has_pins() &&
           aligned.empty();
  }
  // Places that the user gives are in units of the model.
  UvUnits units() const {
    if (uv_units != UvUnits::automatic) return uv_units;
    const bool places = has_pins() || (initial == Initial::input && boundary == Boundary::fixed);
    return places ? UvUnits::model : UvUnits::square;
  }
};

}  // namespace isostretch::app::parameterize
