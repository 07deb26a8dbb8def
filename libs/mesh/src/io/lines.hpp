#pragma once

#include "place.hpp"

#include <string>
#include <string_view>

namespace isostretch::mesh {

// Walks over lines, without their ends (\n or \r\n).
class LineReader {
 public:
  // join_continued: a backslash at the end of a line joins the next one, as in OBJ.
  LineReader(std::string_view text, bool join_continued) : rest_(text), join_continued_(join_continued) {}

  bool next(std::string_view& line);
  long number() const { return number_; }  // of the line last returned, its first if it was joined; from 1

 private:
  std::string_view physical_line();

  std::string_view rest_;
  bool join_continued_;
  long number_ = 0;
  long read_ = 0;
  std::string joined_;
};

// Takes words and numbers from the front of one line; failures carry file name and line number.
class Words {
 public:
  Words(std::string_view line, const std::string& name, long number)
      : rest_(line), name_(name), number_(number) {}

  bool empty();  // nothing but blanks left
  std::string_view word();
  double coordinate(const char* what);  // finite, or an Error
  int integer(const char* what);
  // Next character if there is one, without skipping blanks.
  bool take(char c);
  bool at_blank() const;
  [[noreturn]] void fail(const std::string& what) const { fail_at_line(name_, number_, what); }

 private:
  std::string_view peek_word() const;

  std::string_view rest_;
  const std::string& name_;
  long number_;
};

}  // namespace isostretch::mesh
