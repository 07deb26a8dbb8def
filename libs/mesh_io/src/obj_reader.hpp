#pragma once

#include "face_list.hpp"

#include <isostretch/mesh/types.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::mesh {

// Where statements of an OBJ file stand, for a document that is written again.
struct ObjStatements {
  struct Range {
    std::size_t begin = 0, end = 0;  // from the keyword to behind the last word
  };
  std::vector<Range> faces;     // those that became faces, in order
  std::vector<Range> left_out;  // faces that did not
  std::vector<Range> texture;   // vt
  std::vector<Range> lines;     // l
  bool materials = false;       // mtllib
  CornerMap corners;            // of the triangles of the mesh
};

SurfaceMesh parse_obj(std::string_view text, const std::string& name, const ReadOptions& options,
                      ObjStatements* statements);

}  // namespace isostretch::mesh
