#pragma once

#include <isostretch/deformation/handle_misses.hpp>
#include <isostretch/newton/summary.hpp>

#include <string>
#include <vector>

namespace isostretch::reports {

/// Returns the summary of a solve as a JSON object in one line: status, message, iterations, factorizations
/// and so on; numbers that are not finite become null.
std::string solve_json(const newton::Summary& summary);

/// Returns the seconds of the phases of a solve as a JSON object in one line.
std::string phases_json(const newton::Seconds& seconds);

/// Returns the misses of handles as a JSON list in one line.
std::string misses_json(const std::vector<deformation::HandleMiss>& misses);

/// Returns the table of handles for a page: `handles` is a JSON list as summaries describe them, `misses` is
/// one as misses_json() makes it.
std::string handle_table(const std::string& handles, const std::string& misses);

}  // namespace isostretch::reports
