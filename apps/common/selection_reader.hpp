#pragma once

#include "common/json_value.hpp"

#include <isostretch/handles/selection.hpp>

#include <string>

namespace isostretch::app {

// {"slab": {"axis": "x", "end": "max", "fraction": 0.1}} and the like, docs/apps/isostretch-deform.md has
// all. Throws Error naming the key.
handles::Selection read_selection(const JsonValue& value, int dim);

}  // namespace isostretch::app
