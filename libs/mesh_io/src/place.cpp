#include "place.hpp"

#include "characters.hpp"

#include <isostretch/core/error.hpp>

namespace isostretch::mesh {

void fail_at_line(const std::string& name, long line, const std::string& what) {
  throw Error(name + ":" + std::to_string(line) + ": " + what);
}

// Lines are only counted here: reading need not know them.
void Place::fail(const std::string& what) const {
  if (by_byte) throw Error(name + ": byte " + std::to_string(position) + ": " + what);
  fail_at_line(name, line(), what);
}

long Place::line() const {
  const bool behind_last_line = position > 0 && position == contents.size() && is_line_end(contents.back());
  const std::size_t end = position - (behind_last_line ? 1 : 0);
  long number = 1;
  for (std::size_t i = 0; i < end; ++i)
    number += contents[i] == '\n' || (contents[i] == '\r' && contents.substr(i + 1, 1) != "\n") ? 1 : 0;
  return number;
}

}  // namespace isostretch::mesh
