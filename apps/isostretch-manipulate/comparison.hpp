#pragma once

#include "common/output_folder.hpp"

#include <isostretch/baselines/solver.hpp>

#include <nlohmann/json.hpp>

#include <limits>
#include <string>
#include <vector>

namespace isostretch::app::manipulate {

// One row of a trace.csv of --solver.
struct TraceRow {
  int iteration = 0;
  double seconds = 0, energy = 0, min_eigenvalue = 0, min_determinant = 0;
  int inverted = 0;
};

// What one solver made of the instance, as its own process reported it.
struct Candidate {
  baselines::SolverInfo info;
  std::string status, message;
  Json frame;  // of its summary.json; null where it left none
  std::vector<TraceRow> trace;
  double peak_megabytes = 0;  // of its process
  // NaN where it was not run
  double seconds = std::numeric_limits<double>::quiet_NaN();  // modelling, solving and reading; of its
                                                              // process where it left no account
  double least_seconds = 0, most_seconds = 0;                 // over the repetitions

  bool has_positions() const { return frame.is_object() && frame.contains("file"); }
  bool is_convex() const { return info.kind == baselines::Kind::convex; }
};

struct Comparison {
  std::string name;  // of the scene
  Json mesh;
  // Of the convex problem; NaN where it is not known.
  double optimum = std::numeric_limits<double>::quiet_NaN(),
         lower_bound = std::numeric_limits<double>::quiet_NaN();
  std::vector<Candidate> candidates;
  int repetitions = 1;
  double time_limit = 0, memory_limit = 0;
};

// |E - optimum| / optimum, of the energy of the convex problem.
double relative_error(const Comparison& comparison, double energy);

// The table as CSV, all of it as JSON, the plots as PNG, and a page with both.
std::string comparison_table(const Comparison& comparison);
Json comparison_json(const Comparison& comparison);
std::string draw_comparison(const Comparison& comparison);
std::string comparison_page(const Comparison& comparison, const std::string& plots);

}  // namespace isostretch::app::manipulate
