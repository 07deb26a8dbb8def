#pragma once

#include "place.hpp"
#include "scalar.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::mesh {

enum class Coding { text, little_endian, big_endian };

// A file in memory that holds text, or binary numbers with text around them, read from front to back. Numbers
// are read as the coding says, words and lines always as text; a byte-order mark in front is passed over.
// Failures name the line, or once the coding is binary the byte, of what was read last.
class InputCursor {
 public:
  InputCursor(std::string_view contents, const std::string& name);

  void set_coding(Coding coding);
  bool binary() const { return coding_ != Coding::text; }
  // One item a line: words and numbers are not looked for beyond the end of the line.
  void set_by_line(bool by_line) { by_line_ = by_line; }
  // '#' and the rest of its line count as a blank; so words end there.
  void set_comments(bool comments) { comments_ = comments; }
  // A backslash at the end of a line joins the next one, for words and numbers; line() and next_line() know
  // nothing of it, so that a comment or a name may end in one.
  void set_continued(bool continued) { continued_ = continued; }

  std::size_t position() const { return position_; }
  std::size_t left() const { return contents_.size() - position_; }
  void seek(std::size_t position) { position_ = last_ = position; }
  std::string_view contents() const { return contents_; }
  const std::string& name() const { return name_; }

  // Text. Only blanks are left, in the line or the file.
  bool empty();
  std::string_view word();                // empty where empty() is true
  std::string_view line();                // the rest of the line, without its end; moves on to the next one
  std::string_view rest_of_line() const;  // which stays
  // In text: drops the rest of the line, empty lines and those of comments. To call before every item read by
  // line.
  void next_line();
  // Drops the words that are left of the line and of those joined to it; says where the last one ends.
  std::size_t drop_words();
  double text_coordinate(const char* what);
  std::int64_t text_integer(const char* what);

  // Binary, or text if the coding is. `type` and `bytes` do not matter in text.
  double coordinate(Scalar type, const char* what);  // finite, or an Error
  std::int64_t integer(Scalar type, const char* what);
  std::string_view bytes(std::size_t count, const char* what);
  // A number of items of at least so many bytes each, two being the least in text: a count that what is left
  // cannot hold is refused, so that nothing is allocated for it.
  int count(Scalar type, const char* what, std::size_t bytes_each);
  int text_count(const char* what, std::size_t bytes_each);
  // The same of a count that was read before, at `place`.
  int checked_count(std::int64_t given, const char* what, std::size_t bytes_each, const Place& place) const;
  // From 0 to count - 1, where the file counts from `first`.
  int index(Scalar type, const char* what, int first, std::size_t count);
  // So many numbers on end.
  std::vector<double> coordinates(Scalar type, std::size_t count);
  std::vector<std::int64_t> integers(Scalar type, std::size_t count, const char* what);

  Place place() const { return place(last_); }
  Place place(std::size_t position) const { return {contents_, name_, position, binary()}; }
  [[noreturn]] void fail(const std::string& what) const { place().fail(what); }

 private:
  void skip_blanks();
  void skip_rest_of_line();
  std::size_t joint(std::size_t position) const;
  std::string_view peek_word() const;
  double explained_coordinate(const char* what);
  std::int64_t explained_integer(const char* what);
  const char* number_bytes(Scalar type, const char* what);

  std::string_view contents_;
  const std::string& name_;
  std::size_t start_;  // behind the byte-order mark
  std::size_t position_;
  std::size_t last_;  // where the last thing read began
  Coding coding_ = Coding::text;
  bool swap_ = false;
  bool by_line_ = false;
  bool comments_ = false;
  bool continued_ = false;
  bool old_line_ends_ = false;  // \r alone ends lines: a \n behind it is no part of the end
};

inline constexpr const char* axis_labels[] = {"x coordinate", "y coordinate", "z coordinate"};

// In lower case, for keywords that files write either way.
std::string lower(std::string_view word);

// Out-of-range text of an index, as all readers word it.
std::string out_of_range(const char* what, std::int64_t given, std::size_t count);

}  // namespace isostretch::mesh
