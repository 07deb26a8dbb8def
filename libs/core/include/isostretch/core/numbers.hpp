#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch {

/// Returns the whole text as one finite number, whatever the locale; nothing for any other text.
std::optional<double> finite_number(std::string_view text);
/// Returns the whole text as one whole number; nothing for any other text.
std::optional<int> whole_number(std::string_view text);

/// Returns the parts between the separators, one more than there are separators.
std::vector<std::string> split(std::string_view text, char separator);

}  // namespace isostretch
