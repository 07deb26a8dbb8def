#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace isostretch::mesh {

// The most bytes that so many bytes of a zlib stream can hold: deflate makes 258 of two bits at best.
inline std::uint64_t largest_inflated(std::uint64_t compressed) {
  return 1040 * compressed + 64;
}

// Appends what a zlib stream holds, which has to be `size` bytes. false: it is none, or holds more or less.
bool append_inflated(std::string& bytes, std::string_view stream, std::size_t size);

// A zlib stream that holds the bytes.
std::string deflated(std::string_view bytes);

}  // namespace isostretch::mesh
