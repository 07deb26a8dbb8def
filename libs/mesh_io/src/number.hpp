#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace isostretch::mesh {

// In single quotes, for messages: a long run of garbage is cut short, what does not print becomes a question
// mark.
std::string quoted(std::string_view word);

// A number of a text file, or why the word is none. Independent of the locale.
template <class Number>
struct Parsed {
  Number value = 0;
  std::string fault;  // empty: none; otherwise what follows "x coordinate " in a message
};

// Of the whole word; a plus sign is taken. The fault follows "vertex index " in a message.
Parsed<std::int64_t> parse_integer(std::string_view word);

// Finite; a plus sign is taken, and what is below the range is zero.
Parsed<double> parse_coordinate(std::string_view word);

// As the vertices of a mesh are numbered.
inline constexpr std::int64_t largest_count = std::numeric_limits<int>::max();

}  // namespace isostretch::mesh
