#pragma once

// Meshes as the library takes them, for tests and benchmarks.
#include <isostretch/assembly/elements.hpp>
#include <isostretch/handles/selection.hpp>
#include <isostretch/mesh/element_arrays.hpp>

namespace isostretch::tests {

struct Body {
  assembly::Elements elements;
  handles::Nodes nodes;
};

template <class Points>
Body body(const mesh::ElementArrays& arrays, const Points& points) {
  Body b{assembly::elements_from(arrays), {}};
  b.nodes.dim = arrays.dim;
  b.nodes.positions = Vector::Map(points.data(), points.size());
  return b;
}

}  // namespace isostretch::tests
