#include "source.hpp"

#include "number.hpp"

#include <bit>
#include <charconv>
#include <cmath>

namespace isostretch::mesh {
namespace {

bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
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

void Source::set_coding(Coding coding) {
  coding_ = coding;
  const Coding native =
      std::endian::native == std::endian::little ? Coding::little_endian : Coding::big_endian;
  swap_ = coding != Coding::text && coding != native;
}

void Source::skip_rest_of_line() {
  position_ = std::min(contents_.find('\n', position_), contents_.size());
}

void Source::skip_blanks() {
  for (; position_ < contents_.size(); ++position_) {
    const char c = contents_[position_];
    if (comments_ && c == '#') {
      skip_rest_of_line();
      --position_;  // to meet the line's end
      continue;
    }
    if (!is_space(c) || (by_line_ && c == '\n')) break;
  }
}

bool Source::empty() {
  skip_blanks();
  last_ = position_;
  return position_ == contents_.size() || contents_[position_] == '\n';
}

std::string_view Source::peek_word() const {
  std::size_t end = position_;
  while (end < contents_.size() && !is_space(contents_[end])) ++end;
  return contents_.substr(position_, end - position_);
}

std::string_view Source::word() {
  empty();
  const std::string_view found = peek_word();
  position_ += found.size();
  return found;
}

std::string_view Source::line() {
  last_ = position_;
  skip_rest_of_line();
  std::string_view found = contents_.substr(last_, position_ - last_);
  if (position_ < contents_.size()) ++position_;
  if (!found.empty() && found.back() == '\r') found.remove_suffix(1);
  return found;
}

void Source::next_line() {
  if (binary()) return;
  if (position_ > 0 && contents_[position_ - 1] != '\n') skip_rest_of_line();
  while (position_ < contents_.size() && is_space(contents_[position_])) ++position_;
  last_ = position_;
}

// The usual number ends where a blank begins; everything else is looked at again.
double Source::text_coordinate(const char* what) {
  if (empty()) fail(std::string("missing ") + what);
  const char* const end_of_file = contents_.data() + contents_.size();
  double value = 0;
  const auto [end, error] = std::from_chars(contents_.data() + position_, end_of_file, value);
  if (error != std::errc() || !std::isfinite(value) || (end != end_of_file && !is_space(*end)))
    return explained_coordinate(what);
  position_ = static_cast<std::size_t>(end - contents_.data());
  return value;
}

double Source::explained_coordinate(const char* what) {
  const std::string_view text = peek_word();
  const Parsed<double> parsed = parse_coordinate(text);
  if (!parsed.fault.empty()) fail(std::string(what) + " " + parsed.fault);
  position_ += text.size();
  return parsed.value;
}

std::int64_t Source::text_integer(const char* what) {
  if (empty()) fail(std::string("missing ") + what);
  const std::string_view text = peek_word();
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) fail(std::string(what) + " " + quoted(text) + " is too large");
  if (error != std::errc() || end != text.data() + text.size())
    fail(std::string(what) + " expected, not " + quoted(text));
  position_ += text.size();
  return value;
}

std::string_view Source::bytes(std::size_t count, const char* what) {
  last_ = position_;
  if (count > left()) fail(std::string("the file ends within the ") + what);
  position_ += count;
  return contents_.substr(last_, count);
}

const char* Source::number_bytes(Scalar type, const char* what) {
  last_ = position_;
  if (size_of(type) > left()) fail(std::string("the file ends where the ") + what + " should be");
  position_ += size_of(type);
  return contents_.data() + last_;
}

double Source::coordinate(Scalar type, const char* what) {
  if (!binary()) return text_coordinate(what);
  const double value = load_real(number_bytes(type, what), type, swap_);
  if (!std::isfinite(value)) fail(std::string(what) + " is not finite");
  return value;
}

std::int64_t Source::integer(Scalar type, const char* what) {
  return binary() ? load_integer(number_bytes(type, what), type, swap_) : text_integer(what);
}

int Source::checked_count(std::int64_t given, const char* what, std::size_t bytes_each,
                          const Place& place) const {
  if (given < 0) place.fail(std::string(what) + " is negative: " + std::to_string(given));
  // The last number of a text may lack the blank behind it.
  if (static_cast<std::uint64_t>(given) > (left() + 1) / bytes_each)
    place.fail(std::string(what) + " " + std::to_string(given) + " is more than the file can hold");
  if (given > largest_count) place.fail(std::string(what) + " " + std::to_string(given) + " is too large");
  return static_cast<int>(given);
}

int Source::count(Scalar type, const char* what, std::size_t bytes_each) {
  const std::int64_t given = integer(type, what);
  return checked_count(given, what, bytes_each, place());
}

int Source::text_count(const char* what, std::size_t bytes_each) {
  const std::int64_t given = text_integer(what);
  return checked_count(given, what, bytes_each, place());
}

std::vector<double> Source::coordinates(Scalar type, std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = coordinate(type, axis_labels[i % 3]);
  return values;
}

std::vector<std::int64_t> Source::integers(Scalar type, std::size_t count, const char* what) {
  std::vector<std::int64_t> values(count);
  for (std::int64_t& value : values) value = integer(type, what);
  return values;
}

int Source::index(Scalar type, const char* what, int first, std::size_t count) {
  const std::int64_t given = integer(type, what);
  if (given < first || static_cast<std::uint64_t>(given - first) >= count)
    fail(out_of_range(what, given, count));
  return static_cast<int>(given - first);
}

}  // namespace isostretch::mesh
