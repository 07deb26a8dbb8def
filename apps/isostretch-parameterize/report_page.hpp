#pragma once

#include "report.hpp"

#include <string>

namespace isostretch::app::parameterize {

// Bytes of PNG files.
struct Pictures {
  std::string model, layout;
};

// report.html: what summary.json has, for people, with the pictures inside.
std::string report_page(const Result& result, const Json& summary, const Pictures& pictures);

}  // namespace isostretch::app::parameterize
