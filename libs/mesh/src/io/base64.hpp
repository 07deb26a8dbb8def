#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace isostretch::mesh {

struct Decoded {
  std::string bytes;
  std::size_t fault = std::string_view::npos;  // first character that does not belong there
};

// Blanks and line ends are skipped. Padding may be followed by more: some writers encode the parts of an
// array one by one.
Decoded decode_base64(std::string_view text);

void append_base64(std::string& text, std::string_view bytes);

}  // namespace isostretch::mesh
