#pragma once

#include <string>
#include <string_view>

namespace isostretch::mesh {

// Whole contents; throws Error with the path and the system's reason.
std::string read_file(const std::string& path);

// Appears complete or not at all.
void write_file(const std::string& path, std::string_view contents);

}  // namespace isostretch::mesh
