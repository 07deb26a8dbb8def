#pragma once

#include "input_cursor.hpp"

#include <string_view>
#include <vector>

namespace isostretch::mesh {

struct PlyProperty {
  std::string_view name;
  Scalar type;
  bool list = false;
  Scalar count_type = Scalar::uint8;  // of a list
};

struct PlyElement {
  std::string_view name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
  std::size_t place = 0;  // where the header declares it

  // Index, or the number of properties.
  std::size_t find(std::string_view property) const;
};

// Reads up to end_header and sets the coding; what follows are the elements in this order.
std::vector<PlyElement> read_ply_header(InputCursor& cursor);

}  // namespace isostretch::mesh
