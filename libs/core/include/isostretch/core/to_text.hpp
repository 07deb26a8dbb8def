#pragma once

#include <string>

namespace isostretch {

/// Returns the shortest decimal text that reads back as `value`, bit for bit, whatever the locale; "nan",
/// "inf" and
/// "-inf" for what is not finite. For messages and files: std::to_string() makes 0.000000 of all that is
/// small.
std::string to_text(double value);

}  // namespace isostretch
