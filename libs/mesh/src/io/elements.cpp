#include "elements.hpp"

#include "face_list.hpp"

namespace isostretch::mesh {

std::string ElementList::fault(std::int64_t corners) const {
  if (wanted_ == Shape::face) return face_fault(corners, options_);
  return corners == 4 ? std::string() : "tetrahedron with " + std::to_string(corners) + " vertices";
}

void ElementList::add(const std::vector<int>& corners) {
  if (wanted_ == Shape::face)
    append_fan(corners, corners_);
  else
    corners_.insert(corners_.end(), corners.begin(), corners.end());
}

std::string ElementList::missing() const {
  const long faces = skipped_[0], tets = skipped_[1], others = skipped_[2];
  std::string text = wanted_ == Shape::face ? "no triangles" : "no tetrahedra";
  if (tets > 0)
    text += ": a mesh of " + std::to_string(tets) + " tetrahedra, to be read as such";
  else if (faces > 0)
    text += ": a surface of " + std::to_string(faces) + " faces, to be read as such";
  else if (others > 0)
    text += ", only " + std::to_string(others) + " elements of other kinds";
  return text;
}

SurfaceMesh surface_of(const MixedMesh& mesh) {
  return surface_of(mesh.vertices, mesh.elements.corners());
}

TetMesh tets_of(const MixedMesh& mesh) {
  return {to_rows<double, 3>(mesh.vertices), to_rows<int, 4>(mesh.elements.corners())};
}

}  // namespace isostretch::mesh
