#pragma once

#include "common/output_folder.hpp"

namespace isostretch::app {

// What times depend on besides the program's code: processor, cores, memory in megabytes, system, compiler,
// flags, build type, version, instruction set, threads of parallel loops, and what the environment says of
// threads.
Json machine_json();

// "2026-11-23 14:05:09 UTC".
std::string date_text();

}  // namespace isostretch::app
