#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace isostretch {

/// Decodes from the front, no further than it has to. Blanks and line ends are skipped. Padding may be
/// followed by more: VTK encodes the header of an array and its data one by one.
class Base64Stream {
 public:
  explicit Base64Stream(std::string_view text) : text_(text) {}

  /// Takes the next `count` bytes; false: the text ends before or holds what does not belong there.
  bool take(std::size_t count, std::string& bytes);
  /// Returns whether nothing but blanks is left.
  bool at_end() const;
  std::size_t position() const { return position_; }  // of the text

 private:
  std::string_view text_;
  std::size_t position_ = 0;
  std::string pending_;  // decoded, not taken yet
};

/// Appends the bytes in base64, with padding.
void append_base64(std::string& text, std::string_view bytes);
/// Returns the bytes in base64, with padding.
std::string base64(std::string_view bytes);

}  // namespace isostretch
