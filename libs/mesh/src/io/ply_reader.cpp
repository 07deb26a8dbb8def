#include "face_list.hpp"
#include "file.hpp"
#include "ply_header.hpp"

#include <isostretch/mesh/io.hpp>

namespace isostretch::mesh {
namespace {

class PlyReader {
 public:
  PlyReader(std::string_view contents, const std::string& name, const ReadOptions& options)
      : source_(contents, name), options_(options) {}

  SurfaceMesh read() {
    for (const PlyElement& element : read_ply_header(source_)) {
      if (element.name == "vertex")
        vertices(element);
      else if (element.name == "face")
        faces(element);
      else
        skip(element);
    }
    if (triangles_.empty()) source_.fail(vertices_.empty() ? "no vertices and no faces" : "no faces");
    return surface_of(vertices_, triangles_);
  }

 private:
  // Items of the element. Nothing is in the file for those without properties.
  int item_count(const PlyElement& element) const {
    if (element.properties.empty()) return 0;
    std::size_t bytes = 0;
    for (const PlyProperty& property : element.properties)
      bytes += source_.binary() ? size_of(property.list ? property.count_type : property.type) : 2;
    return source_.checked_count(element.count, "number of elements", bytes, source_.place(element.place));
  }

  void skip_value(Scalar type) {
    if (source_.binary())
      source_.bytes(size_of(type), "property");
    else if (source_.word().empty())
      source_.fail("missing property");
  }

  int list_length(const PlyProperty& property) {
    return source_.count(property.count_type, "length of a list",
                         source_.binary() ? size_of(property.type) : 2);
  }

  void skip(const PlyProperty& property) {
    const int length = property.list ? list_length(property) : 1;
    for (int i = 0; i < length; ++i) skip_value(property.type);
  }

  void skip(const PlyElement& element) {
    for (int i = item_count(element); i > 0; --i) {
      source_.next_line();
      for (const PlyProperty& property : element.properties) skip(property);
    }
  }

  void vertices(const PlyElement& element) {
    constexpr const char* names[] = {"x", "y", "z"};
    std::vector<int> axis(element.properties.size(), -1);
    for (int a = 0; a < 3; ++a) {
      const std::size_t found = element.find(names[a]);
      if (found == axis.size() || element.properties[found].list)
        source_.place(element.place).fail(std::string("vertices have no property ") + names[a]);
      axis[found] = a;
    }
    const std::size_t before = vertices_.size();
    vertices_.resize(before + 3 * static_cast<std::size_t>(item_count(element)));
    for (double* v = vertices_.data() + before; v < vertices_.data() + vertices_.size(); v += 3) {
      source_.next_line();
      for (std::size_t p = 0; p < axis.size(); ++p)
        if (axis[p] >= 0)
          v[axis[p]] = source_.coordinate(element.properties[p].type, axis_labels[axis[p]]);
        else
          skip(element.properties[p]);
    }
  }

  static std::size_t corner_list(const PlyElement& element) {
    const std::size_t found = element.find("vertex_indices");
    return found < element.properties.size() ? found : element.find("vertex_index");
  }

  void faces(const PlyElement& element) {
    const std::size_t corners = corner_list(element);
    if (corners == element.properties.size() || !element.properties[corners].list ||
        is_real(element.properties[corners].type))
      source_.place(element.place).fail("faces have no list of integers vertex_indices or vertex_index");
    for (int i = item_count(element); i > 0; --i) {
      source_.next_line();
      for (std::size_t p = 0; p < element.properties.size(); ++p)
        if (p == corners)
          face(element.properties[p]);
        else
          skip(element.properties[p]);
    }
  }

  void face(const PlyProperty& corners) {
    const int length = list_length(corners);
    if (const std::string fault = face_fault(length, options_); !fault.empty()) source_.fail(fault);
    polygon_.clear();
    for (int c = 0; c < length; ++c)
      polygon_.push_back(source_.index(corners.type, "vertex index", 0, vertices_.size() / 3));
    append_fan(polygon_, triangles_);
  }

  Source source_;
  const ReadOptions& options_;
  std::vector<double> vertices_;
  std::vector<int> triangles_;
  std::vector<int> polygon_;  // of the face being read
};

}  // namespace

SurfaceMesh parse_ply(std::string_view contents, const std::string& name, const ReadOptions& options) {
  return PlyReader(contents, name, options).read();
}

SurfaceMesh read_ply(const std::string& path, const ReadOptions& options) {
  return parse_ply(read_file(path), path, options);
}

}  // namespace isostretch::mesh
