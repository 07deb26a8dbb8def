#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::app {

// The whole text as one finite number (whole number), independent of the locale; nothing otherwise.
std::optional<double> finite_number(std::string_view text);
std::optional<int> whole_number(std::string_view text);

std::vector<std::string> split(std::string_view text, char separator);

}  // namespace isostretch::app
