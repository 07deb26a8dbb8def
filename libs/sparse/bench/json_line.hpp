#pragma once

#include <isostretch/core/text.hpp>

#include <string>

namespace isostretch::sparse::bench {

// An object of JSON on one line, member by member.
class JsonLine {
 public:
  void add(const std::string& name, double value) { append(name, formatted("%.6g", value)); }
  void add(const std::string& name, const std::string& text) { append(name, quoted(text)); }

  std::string text() const { return "{" + members_ + "}"; }

 private:
  static std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
      if (c == '"' || c == '\\') result += '\\';
      result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return result + '"';
  }

  void append(const std::string& name, const std::string& value) {
    members_ += (members_.empty() ? "" : ", ") + quoted(name) + ": " + value;
  }

  std::string members_;
};

}  // namespace isostretch::sparse::bench
