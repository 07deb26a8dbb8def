#pragma once

#include "common/exit_code.hpp"
#include "common/output_folder.hpp"
#include "solve.hpp"

#include <string>

namespace isostretch::app::parameterize {

// Seconds of what surrounds the solve.
struct PhaseSeconds {
  double read = 0;     // file to checked, opened mesh
  double initial = 0;  // rest shape and start
  double write = 0;    // results and picture
  double total = 0;    // since the program began, until summary.json is composed
};

ExitCode exit_code(const Solution& solution);
// What went wrong or well, in one line.
std::string verdict(const Solution& solution);

mesh::SurfaceMesh textured(const Domain& domain, const Solution& solution);
std::string draw(const Domain& domain, const Start& start, const energies::AnyEnergy& energy,
                 const Solution& solution, const Options& options);
Json summary_json(const Domain& domain, const Start& start, const energies::AnyEnergy& energy,
                  const Solution& solution, const Options& options, const PhaseSeconds& seconds);

}  // namespace isostretch::app::parameterize
