#include "face_list.hpp"
#include "file.hpp"
#include "input_cursor.hpp"
#include "number.hpp"
#include "polygon.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/mesh/weld.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <array>
#include <cmath>
#include <numeric>

namespace isostretch::mesh {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t triangle_size = 50;  // a normal and three corners of floats, two more bytes

// Corner points, three a triangle.
class StlReader {
 public:
  StlReader(std::string_view contents, const std::string& name, const ReadOptions& options)
      : cursor_(contents, name), options_(options) {}

  std::vector<double> read() {
    if (is_text())
      text();
    else
      binary();
    if (left_out_ > 0)
      log(LogLevel::info,
          cursor_.name() + ": " + std::to_string(left_out_) + " facet(s) that are no face left out");
    if (corners_.empty()) cursor_.fail("no faces");
    if (corners_.size() / 3 > static_cast<std::size_t>(largest_count)) cursor_.fail("too many faces");
    return std::move(corners_);
  }

 private:
  // Only the length tells for sure: there are binary files that begin with "solid". A text of the same length
  // cannot be, its bytes would make a number of triangles beyond any file.
  bool is_text() const {
    const std::string_view contents = cursor_.contents();
    if (contents.size() >= header_size + 4) {
      const auto triangles = load<std::uint32_t>(contents.data() + header_size, big_endian_machine);
      if (contents.size() == header_size + 4 + triangle_size * std::size_t{triangles}) return false;
    }
    InputCursor start(contents, cursor_.name());
    return lower(start.word()) == "solid" && contents.substr(0, 512).find('\0') == std::string_view::npos;
  }

  void binary() {
    cursor_.set_coding(Coding::little_endian);
    cursor_.bytes(header_size, "header");
    const std::int64_t count = cursor_.integer(Scalar::uint32, "number of triangles");
    const std::uint64_t size = static_cast<std::uint64_t>(count) * triangle_size;
    if (size > cursor_.left() || (size == 0 && cursor_.left() > 0))
      cursor_.fail("neither a text that begins with solid, nor " + std::to_string(count) +
                   " triangles of 50 bytes: " + std::to_string(cursor_.left()) + " bytes follow");
    if (size < cursor_.left())
      log(LogLevel::warning, cursor_.name() + ": " + std::to_string(cursor_.left() - size) +
                                 " bytes follow the " + std::to_string(count) +
                                 " triangles that the file counts; they are not read");
    corners_.reserve(9 * static_cast<std::size_t>(count));
    for (std::int64_t t = 0; t < count; ++t) {
      cursor_.bytes(3 * sizeof(float), "normal");
      for (int i = 0; i < 9; ++i) corners_.push_back(cursor_.coordinate(Scalar::float32, axis_labels[i % 3]));
      cursor_.bytes(2, "attribute");
    }
  }

  // solid name / facet normal x y z / outer loop / vertex x y z ... / endloop / endfacet / endsolid name
  void text() {
    while (!cursor_.empty()) {
      expect("solid");
      cursor_.line();
      std::string keyword = lower(cursor_.word());
      for (; keyword == "facet"; keyword = lower(cursor_.word())) facet();
      if (keyword != "endsolid") fail_expecting("facet or endsolid", keyword);
      cursor_.line();
    }
  }

  void facet() {
    cursor_.line();  // the normal
    expect("outer");
    expect("loop");
    polygon_.clear();
    std::string keyword = lower(cursor_.word());
    for (; keyword == "vertex"; keyword = lower(cursor_.word()))
      for (const char* axis : axis_labels) polygon_.push_back(cursor_.text_coordinate(axis));
    if (keyword != "endloop") fail_expecting("vertex or endloop", keyword);
    add_facet();
    expect("endfacet");
  }

  void add_facet() {
    const std::size_t count = polygon_.size() / 3;
    std::vector<int> triangles;
    if (count == 3) triangles = {0, 1, 2};
    if (count > 3) triangles = triangulated(points_of_facet());
    if (triangles.empty() && !options_.leave_out_faces)
      cursor_.fail("facet with " + std::to_string(count) + " vertices" +
                   (count > 3 ? ", which crosses itself or has no area" : "") + options_.face_advice);
    left_out_ += triangles.empty() ? 1 : 0;
    for (const int corner : triangles)
      for (std::size_t i = 0; i < 3; ++i)
        corners_.push_back(polygon_[3 * static_cast<std::size_t>(corner) + i]);
  }

  std::vector<std::array<double, 3>> points_of_facet() const {
    std::vector<std::array<double, 3>> points;
    for (std::size_t i = 0; i < polygon_.size(); i += 3)
      points.push_back({polygon_[i], polygon_[i + 1], polygon_[i + 2]});
    return points;
  }

  void expect(const char* wanted) {
    const std::string found = lower(cursor_.word());
    if (found != wanted) fail_expecting(wanted, found);
  }

  [[noreturn]] void fail_expecting(const std::string& wanted, const std::string& found) const {
    cursor_.fail(found.empty() ? "the file ends where " + wanted + " should be"
                               : wanted + " expected, not " + quoted(found));
  }

  static constexpr bool big_endian_machine = std::endian::native == std::endian::big;

  InputCursor cursor_;
  const ReadOptions& options_;
  std::vector<double> corners_;
  std::vector<double> polygon_;  // points of the facet being read
  long left_out_ = 0;
};

SurfaceMesh surface_of(const std::vector<double>& points, const std::vector<int>& index) {
  return {to_rows<double, 3>(points), to_rows<int, 3>(index), {}, {}};
}

SurfaceMesh separate(const std::vector<double>& corners) {
  std::vector<int> index(corners.size() / 3);
  std::iota(index.begin(), index.end(), 0);
  return surface_of(corners, index);
}

}  // namespace

SurfaceMesh parse_stl(std::string_view contents, const std::string& name, const ReadOptions& options) {
  if (!(options.weld_tolerance >= 0) || !std::isfinite(options.weld_tolerance))
    throw Error("the welding tolerance is negative or not finite");
  const std::vector<double> corners = StlReader(contents, name, options).read();
  if (!options.weld) return separate(corners);
  const WeldedPoints welded = weld(corners, options.weld_tolerance);
  return surface_of(welded.points, welded.index);
}

SurfaceMesh read_stl(const std::string& path, const ReadOptions& options) {
  return parse_stl(read_file(path), path, options);
}

}  // namespace isostretch::mesh
