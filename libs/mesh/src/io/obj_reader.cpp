#include "face_list.hpp"
#include "file.hpp"
#include "lines.hpp"

#include <isostretch/mesh/io.hpp>

#include <algorithm>
#include <vector>

namespace isostretch::mesh {
namespace {

class ObjReader {
 public:
  ObjReader(const std::string& name, const ReadOptions& options) : name_(name), options_(options) {}

  SurfaceMesh read(std::string_view text) {
    LineReader lines(text, true);
    std::string_view line;
    while (lines.next(line)) statement(line, lines.number());
    return finish(lines.number());
  }

 private:
  void statement(std::string_view line, long number) {
    Words words(line, name_, number);
    const std::string_view keyword = words.word();
    if (keyword == "v")
      vertex(words);
    else if (keyword == "vt" && options_.read_uv)
      texture_coordinate(words);
    else if (keyword == "f")
      face(words, number);
  }

  void vertex(Words& words) {
    for (const char* what : {"x coordinate", "y coordinate", "z coordinate"})
      vertices_.push_back(words.coordinate(what));
  }

  void texture_coordinate(Words& words) {
    uv_.push_back(words.coordinate("u coordinate"));
    uv_.push_back(words.empty() || words.take('#') ? 0.0 : words.coordinate("v coordinate"));
  }

  void face(Words& words, long number) {
    polygon_.clear();
    uv_polygon_.clear();
    while (!words.empty() && !words.take('#')) corner(words, number);
    require_face(words);
    if (!uv_polygon_.empty() && uv_polygon_.size() != polygon_.size())
      words.fail("only some corners of the face have a texture coordinate");
    require_uv_like_before(words);
    append_fan(polygon_, triangles_);
    append_fan(uv_polygon_, uv_triangles_);
  }

  void require_face(Words& words) const {
    const std::string fault = face_fault(static_cast<std::int64_t>(polygon_.size()), options_);
    if (!fault.empty()) words.fail(fault);
  }

  void require_uv_like_before(Words& words) const {
    if (triangles_.empty() || uv_polygon_.empty() == uv_triangles_.empty()) return;
    words.fail(std::string("face ") + (uv_polygon_.empty() ? "without" : "with") +
               " texture coordinates, unlike the faces before: give all faces some, or ignore them all");
  }

  // v, v/t, v/t/n or v//n.
  void corner(Words& words, long number) {
    polygon_.push_back(
        index(words, "vertex", static_cast<int>(vertices_.size() / 3), highest_vertex_, number));
    if (words.take('/')) {
      if (!words.take('/')) {
        texture_index(words, number);
        if (words.take('/')) words.integer("normal index");
      } else {
        words.integer("normal index");
      }
    }
    if (!words.at_blank()) words.fail("face corner is not of the form v, v/t, v/t/n or v//n");
  }

  void texture_index(Words& words, long number) {
    if (options_.read_uv)
      uv_polygon_.push_back(index(words, "texture", static_cast<int>(uv_.size() / 2), highest_uv_, number));
    else
      words.integer("texture index");
  }

  // A face may name vertices that only follow: the highest index is remembered and compared at the end.
  struct Highest {
    int index = -1;
    long line = 0;
  };

  static int index(Words& words, const char* what, int count, Highest& highest, long number) {
    const std::string label = std::string(what) + " index";
    const int given = words.integer(label.c_str());
    if (given == 0) words.fail(label + " 0: OBJ counts from 1");
    const int found = given > 0 ? given - 1 : count + given;
    if (found < 0)
      words.fail(label + " " + std::to_string(given) + " reaches before the first of " +
                 std::to_string(count));
    if (found > highest.index) highest = {found, number};
    return found;
  }

  void require_in_range(const char* what, std::size_t count, const Highest& highest) const {
    if (highest.index < static_cast<long>(count)) return;
    fail_at_line(name_, highest.line,
                 std::string(what) + " index " + std::to_string(highest.index + 1) +
                     " is out of range: there are " + std::to_string(count));
  }

  SurfaceMesh finish(long last_line) const {
    const long line = std::max(last_line, 1L);
    if (vertices_.empty() && triangles_.empty()) fail_at_line(name_, line, "no vertices and no faces");
    if (triangles_.empty()) fail_at_line(name_, line, "no faces");
    require_in_range("vertex", vertices_.size() / 3, highest_vertex_);
    require_in_range("texture", uv_.size() / 2, highest_uv_);
    SurfaceMesh mesh;
    mesh.vertices = to_rows<double, 3>(vertices_);
    mesh.triangles = to_rows<int, 3>(triangles_);
    if (!uv_triangles_.empty()) {
      mesh.uv = to_rows<double, 2>(uv_);
      mesh.uv_triangles = to_rows<int, 3>(uv_triangles_);
    }
    return mesh;
  }

  const std::string& name_;
  const ReadOptions& options_;
  std::vector<double> vertices_, uv_;
  std::vector<int> triangles_, uv_triangles_;
  std::vector<int> polygon_, uv_polygon_;  // of the face being read
  Highest highest_vertex_, highest_uv_;
};

}  // namespace

SurfaceMesh parse_obj(std::string_view text, const std::string& name, const ReadOptions& options) {
  return ObjReader(name, options).read(text);
}

SurfaceMesh read_obj(const std::string& path, const ReadOptions& options) {
  return parse_obj(read_file(path), path, options);
}

}  // namespace isostretch::mesh
