#pragma once

#include "place.hpp"

#include <isostretch/mesh/types.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::mesh {

// Row-by-row growth, then one copy into a matrix.
template <class Scalar, int Columns>
Rows<Scalar, Columns> to_rows(const std::vector<Scalar>& values) {
  return Eigen::Map<const Rows<Scalar, Columns>>(values.data(),
                                                 static_cast<Eigen::Index>(values.size()) / Columns, Columns);
}

// Gives every vertex a pair of texture coordinates, if there are any.
inline SurfaceMesh with_uv(SurfaceMesh mesh, const std::vector<double>& uv) {
  if (!uv.empty()) mesh.uv = to_rows<double, 2>(uv), mesh.uv_triangles = mesh.triangles;
  return mesh;
}

// Where the corners of triangles come from: their face, and their places in its list.
struct CornerMap {
  std::vector<int> face;    // of every triangle, as they were added
  std::vector<int> corner;  // three a triangle, from 0
};

// The faces of a file as it has them; polygons become triangles once the vertices are known.
class FaceList {
 public:
  explicit FaceList(const ReadOptions& options)
      : leave_out_(options.leave_out_faces), advice_(options.face_advice) {}

  // Corners from 0, and as many texture coordinates or none. What is no face (less than three corners) is an
  // Error at `place`, or left out if the options say so; either all faces have texture coordinates or none.
  // Why a face of so many corners is refused; empty where it is not.
  std::string fault(std::size_t corners) const;
  void add(const std::vector<int>& corners, const Place& place) { add(corners, {}, place); }
  void add(const std::vector<int>& corners, const std::vector<int>& uv, const Place& place);

  bool empty() const { return starts_.size() == 1; }
  std::size_t count() const { return starts_.size() - 1; }
  bool has_uv() const { return !uv_.empty(); }
  int size(std::size_t face) const { return starts_[face + 1] - starts_[face]; }
  // Corners of a face.
  const int* corners(std::size_t face) const { return corners_.data() + starts_[face]; }
  // Only those for which keep is not 0.
  void keep(const std::vector<char>& keep);

  // Triangles of a surface with these vertices (x, y, z each) and texture coordinates (u, v). Throws Error at
  // the place of a polygon that cannot be cut into triangles, or leaves it out. Tells the log of faces left
  // out. `origin`, if given, learns where triangles come from.
  SurfaceMesh surface(const std::vector<double>& vertices, const std::vector<double>& uv, const Place& file,
                      CornerMap* origin = nullptr) const;

 private:
  void report_left_out(const Place& file, long polygons) const;

  bool leave_out_;
  std::string advice_;
  std::vector<int> starts_{0};
  std::vector<int> corners_, uv_;
  std::vector<std::size_t> positions_;  // of polygons, in the file
  long left_out_ = 0;
};

}  // namespace isostretch::mesh
