#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace isostretch::deformation {

/// A hash that changes with every bit of what is added (FNV-1a), and tells files from those of the same name
/// before.
class Fingerprint {
 public:
  /// Adds numbers that lie side by side: those of a vector or a matrix.
  template <class Numbers>
  void add(const Numbers& numbers) {
    add_bytes(numbers.data(), static_cast<std::size_t>(numbers.size()) * sizeof(*numbers.data()));
  }

  std::string text() const;  ///< Returns the hash as 16 hexadecimal digits.

 private:
  void add_bytes(const void* data, std::size_t count);

  std::uint64_t hash_ = 14695981039346656037ULL;
};

}  // namespace isostretch::deformation
