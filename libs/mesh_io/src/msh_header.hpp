#pragma once

#include "input_cursor.hpp"

#include <isostretch/mesh_io/io.hpp>

namespace isostretch::mesh {

// Reads $MeshFormat to its end, and lets the cursor take numbers as the file has them. Fails for versions
// other than 2.0 to 2.2, 4.0 and 4.1, and for what is no such section.
MshVersion read_msh_header(InputCursor& cursor);

// Takes the word that must follow.
void expect_word(InputCursor& cursor, const char* word);

}  // namespace isostretch::mesh
