#include "place.hpp"

#include <isostretch/core/error.hpp>

#include <algorithm>

namespace isostretch::mesh {

void fail_at_line(const std::string& name, long line, const std::string& what) {
  throw Error(name + ":" + std::to_string(line) + ": " + what);
}

// Lines are only counted here: reading need not know them.
void Place::fail(const std::string& what) const {
  if (by_byte) throw Error(name + ": byte " + std::to_string(position) + ": " + what);
  const bool behind_last_line = position > 0 && position == contents.size() && contents.back() == '\n';
  const std::string_view before = contents.substr(0, position - (behind_last_line ? 1 : 0));
  fail_at_line(name, 1 + std::count(before.begin(), before.end(), '\n'), what);
}

}  // namespace isostretch::mesh
