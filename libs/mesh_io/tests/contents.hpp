#pragma once

// Contents of a file, written number by number.
#include "sample_mesh.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <string>

namespace isostretch::mesh::test {

// Contents of a file, number by number.
class Contents {
 public:
  explicit Contents(std::endian order = std::endian::little) : order_(order) {}

  Contents& text(const std::string& text) {
    data_ += text;
    return *this;
  }
  Contents& number(double value) {
    char buffer[32];
    data_.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
    return *this;
  }
  template <class T>
  Contents& bytes(T value) {
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (order_ != std::endian::native) std::reverse(raw.begin(), raw.end());
    data_.append(raw.data(), raw.size());
    return *this;
  }
  // Rows of a mesh in either coding.
  Contents& points(const Model& model, bool binary, const std::string& before = "",
                   const std::string& after = "") {
    for (Eigen::Index v = 0; v < model.points.rows(); ++v) {
      data_ += before;
      for (int c = 0; c < 3; ++c) {
        if (binary)
          bytes(model.points(v, c));
        else
          number(model.points(v, c)).text(c < 2 ? " " : "");
      }
      data_ += binary ? "" : after + "\n";
    }
    return *this;
  }
  Contents& elements(const Model& model, const std::string& before = "", int first = 0,
                     const std::string& after = "") {
    for (const auto& element : model.elements) {
      data_ += before;
      for (std::size_t c = 0; c < element.size(); ++c)
        data_ += std::string(c > 0 ? " " : "") + std::to_string(element[c] + first);
      data_ += after + "\n";
    }
    return *this;
  }

  const std::string& str() const { return data_; }

 private:
  std::endian order_;
  std::string data_;
};

inline std::string count_text(std::int64_t count) {
  return std::to_string(count);
}

}  // namespace isostretch::mesh::test
