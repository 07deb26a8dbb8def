#include "scalar.hpp"

#include <limits>

namespace isostretch::mesh {

std::int64_t load_integer(const char* bytes, Scalar type, bool swap) {
  switch (type) {
    case Scalar::int8:
      return load<std::int8_t>(bytes, swap);
    case Scalar::uint8:
      return load<std::uint8_t>(bytes, swap);
    case Scalar::int16:
      return load<std::int16_t>(bytes, swap);
    case Scalar::uint16:
      return load<std::uint16_t>(bytes, swap);
    case Scalar::int32:
      return load<std::int32_t>(bytes, swap);
    case Scalar::uint32:
      return load<std::uint32_t>(bytes, swap);
    case Scalar::int64:
      return load<std::int64_t>(bytes, swap);
    default: {
      constexpr auto largest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
      return static_cast<std::int64_t>(std::min(load<std::uint64_t>(bytes, swap), largest));
    }
  }
}

double load_real(const char* bytes, Scalar type, bool swap) {
  if (type == Scalar::float64) return load<double>(bytes, swap);
  if (type == Scalar::float32) return static_cast<double>(load<float>(bytes, swap));
  return static_cast<double>(load_integer(bytes, type, swap));
}

}  // namespace isostretch::mesh
