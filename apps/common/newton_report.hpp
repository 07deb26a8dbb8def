#pragma once

#include "common/output_folder.hpp"

#include <isostretch/newton/summary.hpp>

#include <string>
#include <vector>

namespace isostretch::app {

// status, message, iterations, factorizations, ... of a solve; numbers that are not finite become null.
Json solve_json(const newton::Summary& summary);
Json phases_json(const newton::Seconds& seconds);

}  // namespace isostretch::app
