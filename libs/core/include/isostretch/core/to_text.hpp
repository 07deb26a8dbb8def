#pragma once

#include <string>

namespace isostretch {

/// Returns the shortest decimal text that reads back as `value`, bit for bit, whatever the locale, and "nan",
/// "inf" or "-inf" for a value that is not finite. Meant for messages and files, where std::to_string() makes
/// 0.000000 of every small number.
std::string to_text(double value);

}  // namespace isostretch
