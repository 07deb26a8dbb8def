#pragma once

#include <string>

// Where test programs find files. Folders are compiled into one source alone, so that a compiler cache serves
// every clone.
namespace isostretch::tests {

/// Returns the path of a file of the repository, given from its root: "tests/golden/sdp".
std::string source_path(const std::string& name);

/// Returns the path of a file of the outside data, which need not be there (conditional.hpp):
/// "meshes/disks/lilium_6k.obj". The data lies in ../shared beside the sources, or where the environment
/// variable ISOSTRETCH_TEST_DATA says.
std::string outside_path(const std::string& name);

}  // namespace isostretch::tests
