#pragma once

#include <string>
#include <vector>

namespace isostretch::sparse::bench {

// What the machine can do at best, as lines of JSON: the compiler, operations a second at every
// instruction-set level and the bandwidth of memory, both with one thread and with all.
std::vector<std::string> machine_peaks();

}  // namespace isostretch::sparse::bench
