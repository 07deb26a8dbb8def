#pragma once

#include "common/exit_code.hpp"
#include "common/output_folder.hpp"
#include "input.hpp"

#include <isostretch/parameterization/parameterize.hpp>

#include <string>

namespace isostretch::app::parameterize {

using parameterization::Chart;
using parameterization::Domain;
using parameterization::Run;

// Seconds of what surrounds the solve.
struct PhaseSeconds {
  double read = 0;     // file to checked, opened mesh
  double initial = 0;  // rest shape and start
  double write = 0;    // results and picture
  double total = 0;    // since the program began, until summary.json is composed
};

// What came of it, all that the reports are made of.
struct Result {
  const Options& options;
  const energies::AnyEnergy& energy;
  const Input& input;
  const parameterization::Parameterization& all;
  const Domain& domain;
  const parameterization::Start& start;
  const parameterization::Solution& solution;
  const parameterization::Layout& layout;
  const parameterization::OverlapSplit& split;
};

ExitCode exit_code(const Result& result);
// What went wrong, in one line; empty when nothing did.
std::string verdict(const Result& result);

std::string trace_text(const Result& result);
std::string draw_layout(const Result& result);
Json summary_json(const Result& result, const PhaseSeconds& seconds);

}  // namespace isostretch::app::parameterize
