#pragma once

#include <isostretch/scene/handles.hpp>
#include <isostretch/scene/value.hpp>

#include <string>

namespace isostretch::scene {

/// Returns the handle that a command line gives, such as
/// "slab:x,max,0.1;rotate=0,0,1:90;translate=0,0,1;soft=10", as a scene gives it. Throws Error, beginning
/// with
/// --handle, for words and numbers that are none; what they mean is up to read_handle_script().
Value handle_from_text(const std::string& text);

/// Returns what --help says of it.
std::string handle_help(Holding holding);

}  // namespace isostretch::scene
