#pragma once

#include "common/handle_reader.hpp"
#include "common/output_folder.hpp"

#include <string>

namespace isostretch::app {

// A handle as the command line gives it, "slab:x,max,0.1;rotate=0,0,1:90;translate=0,0,1;soft=10", as the
// scene gives it. Throws Error, beginning with --handle, for words and numbers that are none; what they mean
// is up to the reader of the scene.
Json handle_from_text(const std::string& text, Holding holding);

// What --help says of it.
std::string handle_help(Holding holding);

}  // namespace isostretch::app
