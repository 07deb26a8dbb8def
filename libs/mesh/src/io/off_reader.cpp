#include "face_list.hpp"
#include "file.hpp"
#include "lines.hpp"

#include <isostretch/mesh/io.hpp>

#include <algorithm>
#include <vector>

namespace isostretch::mesh {
namespace {

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& name, const ReadOptions& options)
      : name_(name), options_(options), size_(text.size()), lines_(text, false) {}

  SurfaceMesh read() {
    header();
    if (face_count_ == 0) fail_at_line(name_, lines_.number(), "no faces");
    std::vector<double> vertices;
    for (int i = 0; i < vertex_count_; ++i) vertex(vertices, i);
    std::vector<int> triangles;
    for (int i = 0; i < face_count_; ++i) face(triangles, i);
    return surface_of(vertices, triangles);
  }

 private:
  // Next line with anything on it besides a comment.
  bool next(std::string_view& line) {
    while (lines_.next(line)) {
      line = line.substr(0, line.find('#'));
      if (!words(line).empty()) return true;
    }
    return false;
  }

  Words words(std::string_view line) const { return {line, name_, lines_.number()}; }

  // [ST][C][N]OFF, the counts on the same line or on the next one. The number of edges is often wrong or
  // missing.
  void header() {
    std::string_view line;
    if (!next(line)) fail_at_line(name_, std::max(lines_.number(), 1L), "no vertices and no faces");
    Words first = words(line);
    const std::string_view keyword = first.word();
    const bool known = keyword.size() >= 3 && keyword.substr(keyword.size() - 3) == "OFF" &&
                       keyword.find_first_not_of("STCNOF") == std::string_view::npos;
    if (!known) first.fail("not an OFF file: it does not begin with OFF");
    if (!first.empty()) {
      counts(first);
      return;
    }
    if (!next(line)) fail_at_line(name_, lines_.number(), "the numbers of vertices and faces are missing");
    Words second = words(line);
    counts(second);
  }

  void counts(Words& line) {
    vertex_count_ = count(line, "number of vertices");
    face_count_ = count(line, "number of faces");
  }

  int count(Words& line, const char* what) {
    line.empty();
    const int value = line.integer(what);
    if (value < 0) line.fail(std::string(what) + " is negative: " + std::to_string(value));
    if (static_cast<std::size_t>(value) > size_)
      line.fail(std::string(what) + " " + std::to_string(value) + " is more than the file can hold");
    return value;
  }

  void vertex(std::vector<double>& vertices, int i) {
    Words line = words(required_line(i, vertex_count_, "vertices"));
    for (const char* what : {"x coordinate", "y coordinate", "z coordinate"})
      vertices.push_back(line.coordinate(what));
  }

  void face(std::vector<int>& triangles, int i) {
    Words line = words(required_line(i, face_count_, "faces"));
    const int corners = count(line, "number of corners");
    if (const std::string fault = face_fault(corners, options_); !fault.empty()) line.fail(fault);
    polygon_.clear();
    for (int c = 0; c < corners; ++c) polygon_.push_back(index(line));
    append_fan(polygon_, triangles);
  }

  int index(Words& line) const {
    if (line.empty()) line.fail("the face has fewer vertices than it says");
    const int value = line.integer("vertex index");
    if (!line.at_blank()) line.fail("vertex index is not an integer");
    if (value < 0 || value >= vertex_count_)
      line.fail("vertex index " + std::to_string(value) + " is out of range: there are " +
                std::to_string(vertex_count_));
    return value;
  }

  std::string_view required_line(int i, int count, const char* what) {
    std::string_view line;
    if (!next(line))
      fail_at_line(name_, lines_.number(),
                   "the file ends after " + std::to_string(i) + " of " + std::to_string(count) + " " + what);
    return line;
  }

  const std::string& name_;
  const ReadOptions& options_;
  std::size_t size_;
  LineReader lines_;
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
