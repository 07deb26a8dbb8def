#pragma once

#include <isostretch/energies/any_energy.hpp>
#include <isostretch/mesh/cut.hpp>
#include <isostretch/newton/options.hpp>

#include <CLI/CLI.hpp>
#include <Eigen/Core>

#include <filesystem>
#include <map>
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
  bool triangulate = false;
  bool repair = false;
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

// The options of this app: declared to CLI11, then read with everything that CLI11 cannot check itself.
class CommandLine {
 public:
  void declare(CLI::App& cli);

  // All of these throw Failure with ExitCode::command_line naming the option at fault.
  Options options() const;
  energies::AnyEnergy energy() const;

 private:
  void declare_energy(CLI::App& cli);
  void declare_pins(CLI::App& cli);
  void declare_cut(CLI::App& cli);
  void declare_layout(CLI::App& cli);
  void declare_solve(CLI::App& cli);
  void declare_files(CLI::App& cli);

  std::string model_, out_, energy_ = "symmetric_dirichlet", projection_ = "adaptive", initial_ = "tutte";
  std::string solver_ = "automatic", ordering_ = "automatic";
  std::vector<std::string> parameters_, pins_, soft_pins_, horizontal_, vertical_;
  std::optional<double> gradient_tolerance_;
  double time_limit_ = 0;
  double max_expansion_ = newton::Options().max_expansion;
  int max_iterations_ = newton::Options{}.max_iterations;
  std::string holes_ = "short", seams_ = "input", boundary_ = "free", corners_, pack_ = "auto";
  int cut_tips_ = Options().cut_tips, max_cuts_ = Options().max_cuts;
  double max_distortion_ = 0, margin_ = Options().margin;
  bool check_ = false, triangulate_ = false, repair_ = false, no_cut_ = false, keep_normalized_ = false,
       no_picture_ = false, glb_ = false;
};

}  // namespace isostretch::app::parameterize
