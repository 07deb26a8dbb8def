#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <string>

namespace isostretch::mesh {

// Shortest decimals that read back to the same bits.
template <class Number>
void append(std::string& text, Number value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  text.append(buffer, result.ptr);
}

// A blank before every number, `offset` added to each.
template <class Matrix>
void append_row(std::string& text, const Matrix& matrix, Eigen::Index row, int offset = 0) {
  for (Eigen::Index c = 0; c < matrix.cols(); ++c) {
    text += ' ';
    if constexpr (std::is_integral_v<typename Matrix::Scalar>)
      append(text, static_cast<long>(matrix(row, c)) + offset);
    else
      append(text, matrix(row, c));
  }
}

// One row a line.
template <class Matrix>
void append_lines(std::string& text, const Matrix& matrix) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    append_row(text, matrix, i);
    text += '\n';
  }
}

// The bytes of a number in memory's order or the other.
template <class T>
void append_bytes(std::string& bytes, T value, std::endian order = std::endian::little) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

template <class Matrix>
void append_row_bytes(std::string& bytes, const Matrix& matrix, Eigen::Index row,
                      std::endian order = std::endian::little) {
  for (Eigen::Index c = 0; c < matrix.cols(); ++c) append_bytes(bytes, matrix(row, c), order);
}

}  // namespace isostretch::mesh
