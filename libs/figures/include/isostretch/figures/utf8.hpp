#pragma once

#include <string>
#include <string_view>

namespace isostretch::figures {

/// Returns the text with U+FFFD in place of what is not UTF-8, as names of files may be anything.
std::string valid_utf8(std::string_view text);

}  // namespace isostretch::figures
