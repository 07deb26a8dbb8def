#include "text.hpp"

#include <isostretch/core/error.hpp>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

namespace isostretch::mesh {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r';
}

// A long run of garbage is not worth repeating in a message.
std::string quoted(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text(1, '\'');
  text += word.substr(0, longest);
  text += word.size() > longest ? "...'" : "'";
  return text;
}

// from_chars leaves numbers below the range (1e-400) to the caller as it does those above.
bool is_tiny(std::string_view word) {
  const std::size_t exponent = word.find_first_of("eE");
  return exponent != std::string_view::npos && exponent + 1 < word.size() && word[exponent + 1] == '-';
}

}  // namespace

std::string read_text(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) throw Error(path + ": cannot read: " + std::strerror(errno));
  std::string text;
  constexpr std::size_t chunk = std::size_t{1} << 20;
  for (std::size_t size = 0;;) {
    text.resize(size + std::max(chunk, size / 2));
    const std::size_t got = std::fread(text.data() + size, 1, text.size() - size, file.get());
    size += got;
    if (got == 0) {
      if (std::ferror(file.get())) throw Error(path + ": cannot read: " + std::strerror(errno));
      text.resize(size);
      return text;
    }
  }
}

void fail_at(const std::string& name, long line, const std::string& what) {
  throw Error(name + ":" + std::to_string(line) + ": " + what);
}

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
  const std::size_t sign = text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data() + sign, text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range && is_tiny(text))
    value = 0;
  else if (error == std::errc::result_out_of_range)
    fail(std::string(what) + " " + quoted(text) + " is too large");
  else if (error != std::errc() || end != text.data() + text.size())
    fail(std::string(what) + " " + quoted(text) + " is not a number");
  if (!std::isfinite(value)) fail(std::string(what) + " " + quoted(text) + " is not finite");
  rest_.remove_prefix(text.size());
  return value;
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
