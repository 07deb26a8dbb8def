#include "face_list.hpp"
#include "file.hpp"
#include "ply_header.hpp"

#include <isostretch/mesh_io/io.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace isostretch::mesh {
namespace {

class PlyReader {
 public:
  PlyReader(std::string_view contents, const std::string& name, const ReadOptions& options)
      : cursor_(contents, name), options_(options), faces_(options) {}

  SurfaceMesh read() {
    for (const PlyElement& element : read_ply_header(cursor_)) {
      if (element.name == "vertex")
        vertices(element);
      else if (element.name == "face")
        faces(element);
      else
        skip(element);
    }
    if (faces_.empty()) cursor_.fail(vertices_.empty() ? "no vertices and no faces" : "no faces");
    return faces_.surface(vertices_, uv_, cursor_.place());
  }

 private:
  // Items of the element. Nothing is in the file for those without properties.
  int item_count(const PlyElement& element) const {
    if (element.properties.empty()) return 0;
    std::size_t bytes = 0;
    for (const PlyProperty& property : element.properties)
      bytes += cursor_.binary() ? size_of(property.list ? property.count_type : property.type) : 2;
    return cursor_.checked_count(element.count, "number of elements", bytes, cursor_.place(element.place));
  }

  void skip_value(Scalar type) {
    if (cursor_.binary())
      cursor_.bytes(size_of(type), "property");
    else if (cursor_.word().empty())
      cursor_.fail("missing property");
  }

  int list_length(const PlyProperty& property) {
    return cursor_.count(property.count_type, "length of a list",
                         cursor_.binary() ? size_of(property.type) : 2);
  }

  void skip(const PlyProperty& property) {
    const int length = property.list ? list_length(property) : 1;
    for (int i = 0; i < length; ++i) skip_value(property.type);
  }

  void skip(const PlyElement& element) {
    for (int i = item_count(element); i > 0; --i) {
      cursor_.next_line();
      for (const PlyProperty& property : element.properties) skip(property);
    }
  }

  // The coordinate, by index, that every property of a vertex is: x, y, z, u, v; -1: none.
  std::vector<int> vertex_columns(const PlyElement& element) const {
    std::vector<int> columns(element.properties.size(), -1);
    const auto number = [&](const char* name) {
      const std::size_t found = element.find(name);
      return found < columns.size() && !element.properties[found].list ? found : columns.size();
    };
    constexpr const char* axes[] = {"x", "y", "z"};
    for (int a = 0; a < 3; ++a) {
      const std::size_t found = number(axes[a]);
      if (found == columns.size())
        cursor_.place(element.place).fail(std::string("vertices have no property ") + axes[a]);
      columns[found] = a;
    }
    if (!options_.read_uv) return columns;
    constexpr std::pair<const char*, const char*> pairs[] = {
        {"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}};
    for (const auto& [u, v] : pairs) {
      if (number(u) == columns.size() || number(v) == columns.size()) continue;
      columns[number(u)] = 3, columns[number(v)] = 4;
      break;
    }
    return columns;
  }

  void vertices(const PlyElement& element) {
    const std::vector<int> columns = vertex_columns(element);
    uv_at_vertices_ = std::find(columns.begin(), columns.end(), 3) != columns.end();
    constexpr const char* labels[] = {"x coordinate", "y coordinate", "z coordinate", "u coordinate",
                                      "v coordinate"};
    for (int i = item_count(element); i > 0; --i) {
      cursor_.next_line();
      std::array<double, 5> values{};
      for (std::size_t p = 0; p < columns.size(); ++p)
        if (columns[p] >= 0)
          values[static_cast<std::size_t>(columns[p])] =
              cursor_.coordinate(element.properties[p].type, labels[columns[p]]);
        else
          skip(element.properties[p]);
      vertices_.insert(vertices_.end(), values.begin(), values.begin() + 3);
      if (uv_at_vertices_) uv_.insert(uv_.end(), values.begin() + 3, values.end());
    }
  }

  static std::size_t corner_list(const PlyElement& element) {
    const std::size_t found = element.find("vertex_indices");
    return found < element.properties.size() ? found : element.find("vertex_index");
  }

  // List of u and v, corner by corner; the number of properties where there is none.
  std::size_t uv_list(const PlyElement& element) const {
    const std::size_t found = element.find("texcoord"), none = element.properties.size();
    return found < none && options_.read_uv && element.properties[found].list ? found : none;
  }

  void faces(const PlyElement& element) {
    const std::size_t corners = corner_list(element), texture = uv_list(element);
    if (corners == element.properties.size() || !element.properties[corners].list ||
        is_real(element.properties[corners].type))
      cursor_.place(element.place).fail("faces have no list of integers vertex_indices or vertex_index");
    if (texture < element.properties.size()) uv_.clear(), uv_at_vertices_ = false;
    for (int i = item_count(element); i > 0; --i) {
      cursor_.next_line();
      const Place place = cursor_.place(cursor_.position());
      polygon_.clear();
      uv_polygon_.clear();
      for (std::size_t p = 0; p < element.properties.size(); ++p)
        if (p == corners)
          read_corners(element.properties[p]);
        else if (p == texture)
          read_uv(element.properties[p]);
        else
          skip(element.properties[p]);
      add_face(place);
    }
  }

  void read_corners(const PlyProperty& corners) {
    const int length = list_length(corners);
    if (const std::string fault = faces_.fault(static_cast<std::size_t>(length)); !fault.empty())
      cursor_.fail(fault);
    for (int c = 0; c < length; ++c)
      polygon_.push_back(cursor_.index(corners.type, "vertex index", 0, vertices_.size() / 3));
  }

  void read_uv(const PlyProperty& list) {
    const int length = list_length(list);
    for (int i = 0; i < length; ++i) {
      const double value = cursor_.coordinate(list.type, i % 2 == 0 ? "u coordinate" : "v coordinate");
      if (i % 2 == 0) uv_polygon_.push_back(static_cast<int>(uv_.size() / 2));
      uv_.push_back(value);
    }
    if (length % 2 != 0) cursor_.fail("texcoord of " + std::to_string(length) + " numbers");
  }

  void add_face(const Place& place) {
    if (uv_at_vertices_) uv_polygon_ = polygon_;
    if (!uv_polygon_.empty() && uv_polygon_.size() != polygon_.size())
      place.fail("face with " + std::to_string(polygon_.size()) + " vertices and " +
                 std::to_string(uv_polygon_.size()) + " texture coordinates");
    faces_.add(polygon_, uv_polygon_, place);
  }

  InputCursor cursor_;
  const ReadOptions& options_;
  FaceList faces_;
  std::vector<double> vertices_, uv_;
  bool uv_at_vertices_ = false;
  std::vector<int> polygon_, uv_polygon_;  // of the face being read
};

}  // namespace

SurfaceMesh parse_ply(std::string_view contents, const std::string& name, const ReadOptions& options) {
  return PlyReader(contents, name, options).read();
}

SurfaceMesh read_ply(const std::string& path, const ReadOptions& options) {
  return parse_ply(read_file(path), path, options);
}

}  // namespace isostretch::mesh
