#include "face_list.hpp"
#include "file.hpp"
#include "input_cursor.hpp"

#include <isostretch/mesh_io/io.hpp>

#include <array>
#include <vector>

namespace isostretch::mesh {
namespace {

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& name, const ReadOptions& options)
      : cursor_(text, name), faces_(options), read_uv_(options.read_uv) {
    cursor_.set_comments(true);
    cursor_.set_by_line(true);
  }

  SurfaceMesh read() {
    header();
    if (face_count_ == 0) cursor_.fail("no faces");
    std::vector<double> vertices;
    for (int i = 0; i < vertex_count_; ++i) vertex(vertices, i);
    for (int i = 0; i < face_count_; ++i) face(i);
    return with_uv(faces_.surface(vertices, {}, cursor_.place()), uv_);
  }

 private:
  // [ST][C][N]OFF, the counts on the same line, with or without a blank, or on the next one. The number of
  // edges is often wrong or missing.
  void header() {
    cursor_.next_line();
    const std::string_view first = cursor_.word();
    if (first.empty()) cursor_.fail("no vertices and no faces");
    const std::size_t name = first.find("OFF"), end = name + 3;
    const bool known = name != std::string_view::npos && first.find_first_not_of("STCN") == name &&
                       (end == first.size() || (first[end] >= '0' && first[end] <= '9'));
    if (!known) cursor_.fail("not an OFF file: it does not begin with OFF");
    has_uv_ = first.substr(0, name).find("ST") != std::string_view::npos;
    cursor_.seek(cursor_.position() - (first.size() - end));
    if (cursor_.empty()) {
      const Place place = cursor_.place();
      cursor_.next_line();
      if (cursor_.left() == 0) place.fail("the numbers of vertices and faces are missing");
    }
    const std::int64_t vertices = cursor_.text_integer("number of vertices");
    const Place place = cursor_.place();
    const std::int64_t faces = cursor_.text_integer("number of faces");
    face_count_ = cursor_.checked_count(faces, "number of faces", 2, cursor_.place());
    vertex_count_ = cursor_.checked_count(vertices, "number of vertices", 2, place);
  }

  void vertex(std::vector<double>& vertices, int i) {
    next_line(i, vertex_count_, "vertices");
    for (const char* what : axis_labels) vertices.push_back(cursor_.text_coordinate(what));
    if (has_uv_ && read_uv_) texture_coordinates();
  }

  // The last two numbers of the line, behind a normal and a colour of three or four.
  void texture_coordinates() {
    std::array<double, 2> last{};
    int count = 0;
    for (; !cursor_.empty(); ++count) last = {last[1], cursor_.text_coordinate("texture coordinate")};
    if (count < 2) cursor_.fail("vertex without texture coordinates, which the first line promises");
    uv_.insert(uv_.end(), last.begin(), last.end());
  }

  void face(int i) {
    next_line(i, face_count_, "faces");
    const Place place = cursor_.place();
    const int corners = cursor_.text_count("number of corners", 2);
    polygon_.clear();
    for (int c = 0; c < corners; ++c) {
      if (cursor_.empty()) cursor_.fail("the face has fewer vertices than it says");
      polygon_.push_back(
          cursor_.index(Scalar::int32, "vertex index", 0, static_cast<std::size_t>(vertex_count_)));
    }
    faces_.add(polygon_, place);
  }

  // What follows on a line (colours and the like) is dropped.
  void next_line(int i, int count, const char* what) {
    const Place place = cursor_.place();
    cursor_.next_line();
    if (cursor_.left() == 0)
      place.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(count) + " " + what);
  }

  InputCursor cursor_;
  FaceList faces_;
  bool read_uv_;
  bool has_uv_ = false;
  std::vector<double> uv_;
  int vertex_count_ = 0;
  int face_count_ = 0;
  std::vector<int> polygon_;
};

}  // namespace

SurfaceMesh parse_off(std::string_view text, const std::string& name, const ReadOptions& options) {
  return OffReader(text, name, options).read();
}

SurfaceMesh read_off(const std::string& path, const ReadOptions& options) {
  return parse_off(read_file(path), path, options);
}

}  // namespace isostretch::mesh
