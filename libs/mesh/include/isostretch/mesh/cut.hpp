#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

struct CutResult {
  SurfaceMesh mesh;                  // the same triangles in the same order; uv is kept
  std::vector<int> original_vertex;  // vertex of the cut mesh -> vertex of the input
  std::vector<int> path;             // vertices of the cut, in the input's numbering
};

// Opens a closed surface of genus 0 along one shortest edge path between two far-apart vertices (the farthest
// from the farthest of vertex 0) of at least three edges. Inner vertices of the path are doubled, copies come
// last; the result is a disk. Throws Error with the reason for anything but a closed connected manifold of
// genus 0, and for one so coarse that no two vertices are three edges apart.
CutResult cut_to_disk_simple(const SurfaceMesh& mesh);

}  // namespace isostretch::mesh
