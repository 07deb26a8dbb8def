#include <isostretch/core/base64.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace isostretch {
namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t invalid = 255, blank = 254, padding = 253;

constexpr std::array<std::uint8_t, 256> make_values() {
  std::array<std::uint8_t, 256> values = {};
  for (std::uint8_t& value : values) value = invalid;
  for (std::size_t i = 0; i < alphabet.size(); ++i)
    values[static_cast<std::size_t>(alphabet[i])] = static_cast<std::uint8_t>(i);
  for (const char c : {' ', '\t', '\r', '\n'}) values[static_cast<std::size_t>(c)] = blank;
  values[static_cast<std::size_t>('=')] = padding;
  return values;
}
constexpr auto values = make_values();

// Four characters make up to three bytes.
struct Group {
  std::uint32_t bits = 0;
  int characters = 0;
  int padded = 0;

  // false: data after padding, or padding before two characters of data.
  bool take(std::uint8_t value) {
    if (value == padding ? characters < 2 : padded > 0) return false;
    bits = bits << 6 | (value == padding ? 0u : value);
    padded += value == padding ? 1 : 0;
    ++characters;
    return true;
  }

  void append_to(std::string& bytes) const {
    for (int i = 0; i < 3 - padded; ++i) bytes += static_cast<char>(bits >> (16 - 8 * i) & 255u);
  }
};

}  // namespace

bool Base64Stream::take(std::size_t count, std::string& bytes) {
  bytes = std::move(pending_);
  pending_.clear();
  for (Group group; bytes.size() < count; group = {}) {
    while (group.characters < 4) {
      if (position_ == text_.size()) return false;
      const std::uint8_t value = values[static_cast<unsigned char>(text_[position_++])];
      if (value != blank && (value == invalid || !group.take(value))) return false;
    }
    group.append_to(bytes);
  }
  pending_ = bytes.substr(count);
  bytes.resize(count);
  return true;
}

bool Base64Stream::at_end() const {
  return pending_.empty() && text_.find_first_not_of(" \t\r\n", position_) == std::string_view::npos;
}

void append_base64(std::string& text, std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? alphabet[bits >> (18 - 6 * k) & 63u] : '=';
  }
}

std::string base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  append_base64(text, bytes);
  return text;
}

}  // namespace isostretch
