#pragma once

#include "common/output_folder.hpp"

#include <isostretch/figures/html.hpp>

#include <nlohmann/json.hpp>

#include <string>

namespace isostretch::app {

namespace html = figures::html;

/// Returns the number as the printf pattern says, and a dash for any other value.
std::string number(const Json& value, const char* pattern);

}  // namespace isostretch::app
