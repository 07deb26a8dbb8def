#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace isostretch::mesh {

[[noreturn]] void fail_at_line(const std::string& name, long line, const std::string& what);

// A place in a file, for messages: by line in text, by byte in what is not.
struct Place {
  std::string_view contents;
  const std::string& name;
  std::size_t position;
  bool by_byte;

  [[noreturn]] void fail(const std::string& what) const;
  long line() const;  // from 1
};

}  // namespace isostretch::mesh
