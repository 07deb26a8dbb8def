#include "lines.hpp"

#include "number.hpp"

#include <charconv>

namespace isostretch::mesh {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r';
}

}  // namespace

std::string_view LineReader::physical_line() {
  ++read_;
  const std::size_t end = rest_.find('\n');
  std::string_view line = rest_.substr(0, end);
  rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

bool LineReader::next(std::string_view& line) {
  if (rest_.empty()) return false;
  line = physical_line();
  number_ = read_;
  if (!join_continued_ || line.empty() || line.back() != '\\') return true;
  joined_.clear();
  while (!line.empty() && line.back() == '\\') {
    joined_.append(line.substr(0, line.size() - 1)).push_back(' ');
    line = rest_.empty() ? std::string_view() : physical_line();
  }
  joined_.append(line);
  line = joined_;
  return true;
}

bool Words::empty() {
  while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
  return rest_.empty();
}

std::string_view Words::peek_word() const {
  std::size_t end = 0;
  while (end < rest_.size() && !is_blank(rest_[end])) ++end;
  return rest_.substr(0, end);
}

std::string_view Words::word() {
  empty();
  const std::string_view found = peek_word();
  rest_.remove_prefix(found.size());
  return found;
}

bool Words::take(char c) {
  if (rest_.empty() || rest_.front() != c) return false;
  rest_.remove_prefix(1);
  return true;
}

bool Words::at_blank() const {
  return rest_.empty() || is_blank(rest_.front());
}

double Words::coordinate(const char* what) {
  if (empty()) fail(std::string("missing ") + what);
  const std::string_view text = peek_word();
  const Parsed<double> parsed = parse_coordinate(text);
  if (!parsed.fault.empty()) fail(std::string(what) + " " + parsed.fault);
  rest_.remove_prefix(text.size());
  return parsed.value;
}

int Words::integer(const char* what) {
  const std::string_view text = peek_word();
  int value = 0;
  const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) fail(std::string(what) + " " + quoted(text) + " is too large");
  if (error != std::errc()) fail(std::string(what) + " expected, not " + quoted(text));
  rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
  return value;
}

}  // namespace isostretch::mesh
