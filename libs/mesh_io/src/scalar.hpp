#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace isostretch::mesh {

// Types of numbers in binary files.
enum class Scalar { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

constexpr std::size_t size_of(Scalar type) {
  constexpr std::array<std::size_t, 10> sizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

constexpr bool is_real(Scalar type) {
  return type == Scalar::float32 || type == Scalar::float64;
}

// From memory of any alignment, in the other byte order if `swap`.
template <class T>
T load(const char* bytes, bool swap) {
  std::array<char, sizeof(T)> copy;
  std::memcpy(copy.data(), bytes, sizeof(T));
  if (swap) std::reverse(copy.begin(), copy.end());
  return std::bit_cast<T>(copy);
}

double load_real(const char* bytes, Scalar type, bool swap);
// Of an integer type; what int64 cannot hold becomes its largest number, too large for any use here.
std::int64_t load_integer(const char* bytes, Scalar type, bool swap);

}  // namespace isostretch::mesh
