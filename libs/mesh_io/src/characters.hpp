#pragma once

#include <cstddef>
#include <string_view>

namespace isostretch::mesh {

// What every text format agrees on: blanks, ends of lines, and the mark that some editors put first.

inline bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

// A line ends with \n, with \r\n or, as on old Macintoshes, with \r alone.
inline bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

// Bytes of UTF-8's byte-order mark in front, or 0.
inline std::size_t byte_order_mark(std::string_view contents) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return contents.substr(0, mark.size()) == mark ? mark.size() : 0;
}

inline std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace isostretch::mesh
