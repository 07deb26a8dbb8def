#pragma once

#include "common/deformation_names.hpp"
#include "scene.hpp"

#include "common/exit_code.hpp"
#include "common/output_folder.hpp"
#include "options.hpp"

#include <isostretch/deformation/elastic_problem.hpp>
#include <isostretch/deformation/sequence.hpp>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace isostretch::app::deform {

// Seconds of this run.
struct PhaseSeconds {
  double read = 0;   // mesh and scene to the problem
  double solve = 0;  // all frames
  double write = 0;  // frames, state, pictures
  double total = 0;
};

enum class Outcome { finished, stop_after, stopped, failed };

// What came of it, all that the reports are made of.
struct Result {
  const Scene& scene;
  const SolidModel& body;
  const HandleSet& handle_set;
  const deformation::ElasticProblem& problem;
  Outcome outcome = Outcome::finished;
  std::string message;   // of the frame that ended it, when not finished
  Json frames;           // an entry for each, an unfinished one included
  std::string trace;     // trace.csv
  Vector positions;      // of the last frame
  int restarted_at = 0;  // first frame made in this run
  std::vector<std::string> warnings;
};

// An entry of "frames" in summary.json, `handles` as misses_json() has them. Frame 0 is the rest shape,
// without a solve.
Json frame_json(int frame, const deformation::FrameResult& result, double time, const StrainField& strain,
                const Json& handles, const std::string& file);
Json rest_frame_json(const Result& result, const StrainField& strain, const std::string& file);

// Rows of trace.csv, with the head if asked.
std::string trace_rows(int frame, const newton::Summary& summary, bool head);

int inverted_frames(const Result& result);
int unconverged_frames(const Result& result);
ExitCode exit_code(const Result& result);
// What went wrong or well, in one line.
std::string verdict(const Result& result);

Json summary_json(const Result& result, const PhaseSeconds& seconds);
std::string draw(const Result& result, const Strain& strain);
std::string report_page(const Result& result, const Json& summary, const std::string& picture,
                        const std::string& preview);

}  // namespace isostretch::app::deform
