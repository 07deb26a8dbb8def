#pragma once

#include <isostretch/handles/selection.hpp>
#include <isostretch/scene/node.hpp>

namespace isostretch::scene {

/// Reads a selection of nodes, such as "all" or {"box": ...}, of a body of that dimension. Throws Error
/// naming the key by its path.
handles::Selection read_selection(const Node& value, int dim);

}  // namespace isostretch::scene
