#pragma once

#include <isostretch/comparison/record.hpp>

#include <string>

namespace isostretch::comparison {

/// Returns what times depend on besides the program's code: processor, cores, memory in megabytes, system,
/// compiler, flags, build type, version, instruction set, the threads of parallel loops, and what the
/// environment says of threads.
Record machine_record(int threads);

/// Returns the date and time now, "2026-11-23 14:05:09 UTC".
std::string date_text();

}  // namespace isostretch::comparison
