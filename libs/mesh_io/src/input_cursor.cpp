#include "input_cursor.hpp"

#include "characters.hpp"
#include "number.hpp"

#include <bit>
#include <charconv>
#include <cmath>

namespace isostretch::mesh {
namespace {

bool has_old_line_ends(std::string_view contents) {
  const std::size_t first = contents.find_first_of("\r\n");
  return first != std::string_view::npos && contents[first] == '\r' && contents.substr(first + 1, 1) != "\n";
}

}  // namespace

std::string out_of_range(const char* what, std::int64_t given, std::size_t count) {
  return std::string(what) + " " + std::to_string(given) + " is out of range: there are " +
         std::to_string(count);
}

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

void InputCursor::set_coding(Coding coding) {
  coding_ = coding;
  const Coding native =
      std::endian::native == std::endian::little ? Coding::little_endian : Coding::big_endian;
  swap_ = coding != Coding::text && coding != native;
}

InputCursor::InputCursor(std::string_view contents, const std::string& name)
    : contents_(contents),
      name_(name),
      start_(byte_order_mark(contents)),
      position_(start_),
      last_(start_),
      old_line_ends_(has_old_line_ends(contents)) {}

void InputCursor::skip_rest_of_line() {
  while (position_ < contents_.size() && !is_line_end(contents_[position_])) ++position_;
}

// Length of a backslash and the end of the line behind it, 0 where there is none.
std::size_t InputCursor::joint(std::size_t position) const {
  if (!continued_ || contents_[position] != '\\') return 0;
  const std::string_view rest = contents_.substr(position + 1, 2);
  if (rest.empty()) return 1;
  if (!is_line_end(rest[0])) return 0;
  return rest == "\r\n" ? 3 : 2;
}

void InputCursor::skip_blanks() {
  while (position_ < contents_.size()) {
    const char c = contents_[position_];
    if (comments_ && c == '#') {
      skip_rest_of_line();
    } else if (const std::size_t length = joint(position_)) {
      position_ += length;
    } else {
      if (!is_space(c) || (by_line_ && is_line_end(c))) break;
      ++position_;
    }
  }
}

bool InputCursor::empty() {
  skip_blanks();
  last_ = position_;
  return position_ == contents_.size() || is_line_end(contents_[position_]);
}

std::string_view InputCursor::peek_word() const {
  std::size_t end = position_;
  while (end < contents_.size() && !is_space(contents_[end]) && !(comments_ && contents_[end] == '#') &&
         joint(end) == 0)
    ++end;
  return contents_.substr(position_, end - position_);
}

std::string_view InputCursor::word() {
  empty();
  const std::string_view found = peek_word();
  position_ += found.size();
  return found;
}

std::string_view InputCursor::line() {
  last_ = position_;
  skip_rest_of_line();
  const std::string_view found = contents_.substr(last_, position_ - last_);
  const std::string_view end = contents_.substr(position_, 2);
  position_ += std::min<std::size_t>(end.size(), end == "\r\n" && !old_line_ends_ ? 2 : 1);
  return found;
}

std::string_view InputCursor::rest_of_line() const {
  const std::string_view rest = contents_.substr(position_);
  return rest.substr(0, rest.find_first_of("\r\n"));
}

void InputCursor::next_line() {
  if (binary()) return;
  if (position_ > start_ && !is_line_end(contents_[position_ - 1])) skip_rest_of_line();
  for (; position_ < contents_.size(); ++position_) {
    if (comments_ && contents_[position_] == '#') skip_rest_of_line();
    if (position_ == contents_.size() || !is_space(contents_[position_])) break;
  }
  last_ = position_;
}

std::size_t InputCursor::drop_words() {
  std::size_t end = position_;
  while (!empty()) end = position_ += peek_word().size();
  return end;
}

// The usual number ends where a blank begins; everything else is looked at again.
double InputCursor::text_coordinate(const char* what) {
  if (empty()) fail(std::string("missing ") + what);
  const char* const end_of_file = contents_.data() + contents_.size();
  double value = 0;
  const auto [end, error] = std::from_chars(contents_.data() + position_, end_of_file, value);
  if (error != std::errc() || !std::isfinite(value) || (end != end_of_file && !is_space(*end)))
    return explained_coordinate(what);
  position_ = static_cast<std::size_t>(end - contents_.data());
  return value;
}

double InputCursor::explained_coordinate(const char* what) {
  const std::string_view text = peek_word();
  const Parsed<double> parsed = parse_coordinate(text);
  if (!parsed.fault.empty()) fail(std::string(what) + " " + parsed.fault);
  position_ += text.size();
  return parsed.value;
}

// The usual one has no plus sign and ends where a blank begins.
std::int64_t InputCursor::text_integer(const char* what) {
  if (empty()) fail(std::string("missing ") + what);
  const char* const end_of_file = contents_.data() + contents_.size();
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(contents_.data() + position_, end_of_file, value);
  if (error != std::errc() || (end != end_of_file && !is_space(*end))) return explained_integer(what);
  position_ = static_cast<std::size_t>(end - contents_.data());
  return value;
}

std::int64_t InputCursor::explained_integer(const char* what) {
  const std::string_view text = peek_word();
  const Parsed<std::int64_t> parsed = parse_integer(text);
  if (!parsed.fault.empty()) fail(std::string(what) + " " + parsed.fault);
  position_ += text.size();
  return parsed.value;
}

std::string_view InputCursor::bytes(std::size_t count, const char* what) {
  last_ = position_;
  if (count > left()) fail(std::string("the file ends within the ") + what);
  position_ += count;
  return contents_.substr(last_, count);
}

const char* InputCursor::number_bytes(Scalar type, const char* what) {
  last_ = position_;
  if (size_of(type) > left()) fail(std::string("the file ends where the ") + what + " should be");
  position_ += size_of(type);
  return contents_.data() + last_;
}

double InputCursor::coordinate(Scalar type, const char* what) {
  if (!binary()) return text_coordinate(what);
  const double value = load_real(number_bytes(type, what), type, swap_);
  if (!std::isfinite(value)) fail(std::string(what) + " is not finite");
  return value;
}

std::int64_t InputCursor::integer(Scalar type, const char* what) {
  return binary() ? load_integer(number_bytes(type, what), type, swap_) : text_integer(what);
}

int InputCursor::checked_count(std::int64_t given, const char* what, std::size_t bytes_each,
                               const Place& place) const {
  if (given < 0) place.fail(std::string(what) + " is negative: " + std::to_string(given));
  // The last number of a text may lack the blank behind it.
  if (static_cast<std::uint64_t>(given) > (left() + 1) / bytes_each)
    place.fail(std::string(what) + " " + std::to_string(given) + " is more than the file can hold");
  if (given > largest_count) place.fail(std::string(what) + " " + std::to_string(given) + " is too large");
  return static_cast<int>(given);
}

int InputCursor::count(Scalar type, const char* what, std::size_t bytes_each) {
  const std::int64_t given = integer(type, what);
  return checked_count(given, what, bytes_each, place());
}

int InputCursor::text_count(const char* what, std::size_t bytes_each) {
  const std::int64_t given = text_integer(what);
  return checked_count(given, what, bytes_each, place());
}

std::vector<double> InputCursor::coordinates(Scalar type, std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = coordinate(type, axis_labels[i % 3]);
  return values;
}

std::vector<std::int64_t> InputCursor::integers(Scalar type, std::size_t count, const char* what) {
  std::vector<std::int64_t> values(count);
  for (std::int64_t& value : values) value = integer(type, what);
  return values;
}

int InputCursor::index(Scalar type, const char* what, int first, std::size_t count) {
  const std::int64_t given = integer(type, what);
  if (given < first || static_cast<std::uint64_t>(given - first) >= count)
    fail(out_of_range(what, given, count));
  return static_cast<int>(given - first);
}

}  // namespace isostretch::mesh
