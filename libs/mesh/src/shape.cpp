#include <isostretch/mesh/shape.hpp>

namespace isostretch::mesh {
namespace {

struct ShapeFacts {
  const char* name;
  int dim;
  int nodes;
};

// In the order of Shape.
constexpr ShapeFacts facts[] = {{"triangle", 2, 3}, {"quadratic triangle", 2, 6}, {"quad", 2, 4},
                                {"tet", 3, 4},      {"quadratic tet", 3, 10},     {"hex", 3, 8}};

const ShapeFacts& facts_of(Shape shape) {
  return facts[static_cast<int>(shape)];
}

}  // namespace

const char* shape_name(Shape shape) noexcept {
  return facts_of(shape).name;
}

int shape_dim(Shape shape) noexcept {
  return facts_of(shape).dim;
}

int shape_node_count(Shape shape) noexcept {
  return facts_of(shape).nodes;
}

}  // namespace isostretch::mesh
