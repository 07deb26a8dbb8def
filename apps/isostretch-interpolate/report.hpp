#pragma once

#include "common/deformation_names.hpp"

#include "common/exit_code.hpp"
#include "common/output_folder.hpp"
#include "options.hpp"

#include <isostretch/deformation/interpolation.hpp>
#include <isostretch/deformation/key_shapes.hpp>
#include <isostretch/energies/any_energy.hpp>

#include <nlohmann/json.hpp>

#include <array>
#include <string>
#include <vector>

namespace isostretch::app::interpolate {

struct PhaseSeconds {
  double read = 0;   // meshes to the problem
  double solve = 0;  // all frames
  double write = 0;  // frames and pictures
  double total = 0;
};

// A frame as the pictures show it.
struct Snapshot {
  int number = 0;
  double time = 0;
  Vector positions;
};

enum class Outcome { finished, stopped, failed };

// What came of it, all that the reports are made of.
struct Result {
  const Options& options;
  const deformation::KeyShapes& poses;
  const energies::AnyEnergy& energy;
  Outcome outcome = Outcome::finished;
  std::string message = {};  // of the frame that ended it, when not finished
  Json frames = Json::array();
  std::string trace = {};  // trace.csv
  newton::Seconds phases = {};
  std::string solver = {};               // of the linear systems
  std::vector<Snapshot> snapshots = {};  // a handful for the picture, the last frame made among them
  std::vector<std::string> warnings = {};
};

// Against both rest shapes.
using Strains = std::array<StrainField, 2>;

// Adds an entry of "frames" in summary.json, rows of trace.csv, and to the sums.
void add_frame(Result& result, const deformation::InterpolationFrame& frame, const Strains& strains,
               const std::string& file);

// Whether the last frame is much further from the one before than frames are elsewhere: the way has ended in
// another minimum than the second pose.
bool jumps_at_the_end(const Result& result);

ExitCode exit_code(const Result& result);
// What went wrong or well, in one line.
std::string verdict(const Result& result);

Json summary_json(const Result& result, const PhaseSeconds& seconds);
// interpolation.png and energy.png.
std::string draw_frames(const Result& result);
std::string draw_energies(const Result& result);

std::string report_page(const Result& result, const Json& summary, const std::string& frames,
                        const std::string& energies, const std::string& preview);

}  // namespace isostretch::app::interpolate
