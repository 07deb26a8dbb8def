#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace isostretch {

/// A decoder of base64 that takes bytes from the front of a text and decodes no further than it has to.
/// Blanks and line ends are skipped. Padding may be followed by more text: VTK encodes the header of an array
/// and its data separately.
class Base64Stream {
 public:
  /// Makes a decoder that reads from `text`, which must outlive it.
  explicit Base64Stream(std::string_view text) : text_(text) {}

  /// Takes the next `count` bytes. Returns false if the text ends before that or holds a character that does
  /// not belong there.
  bool take(std::size_t count, std::string& bytes);
  /// Returns whether nothing but blanks is left.
  bool at_end() const;
  /// Returns how many characters of the text have been read.
  std::size_t position() const { return position_; }

 private:
  std::string_view text_;
  std::size_t position_ = 0;
  std::string pending_;  ///< Bytes that are decoded and not taken yet.
};

/// Appends the bytes in base64, with padding, to the text.
void append_base64(std::string& text, std::string_view bytes);
/// Returns the bytes in base64, with padding.
std::string base64(std::string_view bytes);

}  // namespace isostretch
