#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace isostretch {

/// Returns what printf would print, however long that is.
template <class... Arguments>
std::string formatted(const char* pattern, Arguments... arguments) {
  std::string text(static_cast<std::size_t>(std::snprintf(nullptr, 0, pattern, arguments...)), '\0');
  std::snprintf(text.data(), text.size() + 1, pattern, arguments...);
  return text;
}

/// Returns the number with commas between thousands: 1234567 as "1,234,567".
inline std::string with_thousands(long long count) {
  std::string text = std::to_string(count);
  const std::size_t first = count < 0 ? 1 : 0;
  for (std::size_t i = text.size(); i > first + 3;) text.insert(i -= 3, 1, ',');
  return text;
}

/// Returns the name of a status or of an option as words: "stopped_iterations" as "stopped iterations".
inline std::string in_words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// Returns a count with its noun: "1 chart", "1,234 charts". `what` is the singular, whose plural ends in s.
template <class Count>
std::string counted(Count count, const std::string& what) {
  return with_thousands(static_cast<long long>(count)) + " " + what + (count == 1 ? "" : "s");
}

/// Returns the texts with commas between: "a, b, c".
inline std::string listed(const std::vector<std::string>& texts) {
  std::string text;
  for (const std::string& one : texts) text += (text.empty() ? "" : ", ") + one;
  return text;
}

}  // namespace isostretch
