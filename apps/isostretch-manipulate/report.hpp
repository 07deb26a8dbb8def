#pragma once

#include "common/deformation_names.hpp"
#include "frame.hpp"

#include "common/exit_code.hpp"
#include "common/output_folder.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace isostretch::app::manipulate {

struct PhaseSeconds {
  double read = 0;     // mesh and scene
  double weights = 0;  // of the handles
  double solve = 0;    // all frames
  double write = 0;    // frames and pictures
  double total = 0;
};

// A frame with how its body is strained.
struct Shape {
  StrainField strain;
  std::vector<double> eigenvalues;  // of every element the least of S
  int indefinite = 0;               // elements with one below the margin
};

enum class Outcome { finished, stopped };

// What came of it, all that the reports are made of.
struct Result {
  const Scene& scene;
  const SolidModel& body;
  const HandleSet& handle_set;
  const deformation::ElementRotations& rotations;
  std::string name;  // of the scene file, or of the body
  Outcome outcome = Outcome::finished;
  std::string message = {};     // why it was stopped
  int wanted = 0;               // frames
  Json frames = Json::array();  // an entry for each
  Trace trace = {};             // trace.csv
  FrameResult last = {};        // the last frame that has positions
  std::vector<std::string> warnings = {};
};

Shape shape_of(const Result& result, const Strain& strain, const std::vector<double>& rotations,
               const Vector& positions);

// Adds an entry of "frames" in summary.json and rows of trace.csv; `before` and `after` are not looked at
// where the frame has no positions.
void add_frame(Result& result, const FrameResult& frame, const Shape& before, const Shape& after,
               const std::string& file);
void add_rest_frame(Result& result, const StrainField& strain, const std::string& file);

ExitCode exit_code(const Result& result);
// What went wrong or well, in one line.
std::string verdict(const Result& result);

Json summary_json(const Result& result, const PhaseSeconds& seconds);

// The last frame made: at rest, before and after; and the way there.
std::string draw_states(const Result& result, const Strain& strain);
std::string draw_path(const Result& result, const Strain& strain);

std::string report_page(const Result& result, const Json& summary, const std::string& states,
                        const std::string& path, const std::string& preview);

}  // namespace isostretch::app::manipulate
