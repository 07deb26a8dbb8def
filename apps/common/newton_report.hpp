#pragma once

#include "common/output_folder.hpp"

#include <isostretch/newton/summary.hpp>

#include <string>
#include <vector>

namespace isostretch::app {

// Every iteration a line, numbers with all their digits.
std::string trace_csv(const newton::Summary& summary);
// With one column more that the app gives.
std::string trace_csv(const newton::Summary& summary, const std::string& name,
                      const std::vector<int>& column);

// status, message, iterations, factorizations, ... of a solve; numbers that are not finite become null.
Json solve_json(const newton::Summary& summary);
Json phases_json(const newton::Seconds& seconds);

// One line for show_progress().
std::string progress_line(const newton::Iteration& row);

}  // namespace isostretch::app
