#pragma once

#include <isostretch/mesh/cut.hpp>
#include <isostretch/newton/options.hpp>

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
  bool keep_normalized = false;
  bool picture = true;
  bool glb = false;
  std::vector<Pin> pins;
  std::vector<SoftPin> soft_pins;
  std::vector<AlignedVertices> aligned;
  newton::Options newton;

  bool has_pins() const { return !pins.empty() || !soft_pins.empty(); }
  // Whether so many charts are moved into the unit square.
  bool packs(std::size_t charts) const {
    if (pack != Pack::automatic) return pack == Pack::square;
    return charts > 1 && initial != Initial::input;
  }
};

}  // namespace isostretch::app::parameterize
