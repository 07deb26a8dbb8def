#include "file.hpp"
#include "number.hpp"
#include "source.hpp"
#include "vtk_cells.hpp"

#include <isostretch/mesh/io.hpp>

#include <array>
#include <utility>

namespace isostretch::mesh {
namespace {

class VtkReader {
 public:
  VtkReader(std::string_view contents, const std::string& name, Shape wanted, const ReadOptions& options)
      : source_(contents, name), elements_(wanted, options) {}

  MixedMesh read() {
    header();
    while (statement()) {
    }
    if (grid_.count() != types_.size())
      source_.fail(std::to_string(types_.size()) + " cell types for " + std::to_string(grid_.count()) +
                   " cells");
    add(grid_, types_, source_.place(grid_start_));
    if (elements_.empty()) source_.fail(elements_.missing());
    return {std::move(vertices_), std::move(elements_)};
  }

 private:
  void header() {
    const std::string start = "# vtk DataFile Version ";
    const std::string_view line = source_.line();
    if (line.substr(0, start.size()) != start)
      source_.fail("not a VTK file: it does not begin with " + start);
    const std::string_view version = line.substr(start.size());
    if (version.size() < 3 || version[0] < '1' || version[0] > '5' || version[1] != '.')
      source_.fail("version " + quoted(version) + " is none of 1 to 5");
    offset_layout_ = version[0] == '5';
    source_.line();  // a title
    const std::string coding = lower(source_.word());
    if (coding != "ascii" && coding != "binary")
      source_.fail("ASCII or BINARY expected, not " + quoted(coding));
    source_.line();
    dataset();
    if (coding == "binary") source_.set_coding(Coding::big_endian);
  }

  void dataset() {
    if (lower(source_.word()) != "dataset") source_.fail("DATASET expected");
    const std::string kind = lower(source_.word());
    if (kind != "polydata" && kind != "unstructured_grid")
      source_.fail("dataset " + quoted(kind) + " is neither POLYDATA nor UNSTRUCTURED_GRID");
    source_.line();
  }

  // false: the geometry ends, with the file or where data of points and cells begin.
  bool statement() {
    const std::string keyword = lower(source_.word());
    if (keyword.empty() || keyword == "point_data" || keyword == "cell_data") return false;
    if (keyword == "points")
      points();
    else if (keyword == "polygons")
      add_section(vtk_polygon);
    else if (keyword == "triangle_strips")
      add_section(vtk_triangle_strip);
    else if (keyword == "vertices" || keyword == "lines")
      add_section(no_type);
    else if (keyword == "cells")
      grid();
    else if (keyword == "cell_types")
      cell_types();
    else if (keyword == "metadata")
      skip_metadata();
    else if (keyword == "field")
      skip_field();
    else
      source_.fail("unknown keyword " + quoted(keyword));
    return true;
  }

  Scalar type() {
    constexpr std::array<std::pair<std::string_view, Scalar>, 14> types = {
        {{"char", Scalar::int8},
         {"unsigned_char", Scalar::uint8},
         {"short", Scalar::int16},
         {"unsigned_short", Scalar::uint16},
         {"int", Scalar::int32},
         {"unsigned_int", Scalar::uint32},
         {"long", Scalar::int64},
         {"unsigned_long", Scalar::uint64},
         {"float", Scalar::float32},
         {"double", Scalar::float64},
         {"vtkidtype", Scalar::int32},
         {"vtktypeint32", Scalar::int32},
         {"vtktypeint64", Scalar::int64},
         {"vtktypeuint64", Scalar::uint64}}};
    const std::string name = lower(source_.word());
    for (const auto& [known, type] : types)
      if (known == name) return type;
    source_.fail("unknown type " + quoted(name));
  }

  std::size_t bytes_of(Scalar type) const { return source_.binary() ? size_of(type) : 2; }

  void points() {
    if (has_points_) source_.fail("POINTS for the second time");
    has_points_ = true;
    const std::int64_t given = source_.text_integer("number of points");
    const Place place = source_.place();
    const Scalar number = type();
    source_.line();
    const int count = source_.checked_count(given, "number of points", 3 * bytes_of(number), place);
    vertices_ = source_.coordinates(number, 3 * static_cast<std::size_t>(count));
  }

  // Cells of one type, which need not be kept.
  void add_section(std::int64_t cell_type) {
    const Place place = source_.place();
    const VtkCells read = cells();
    add(read, std::vector<std::int64_t>(read.count(), cell_type), place);
  }

  void add(const VtkCells& cells, const std::vector<std::int64_t>& types, const Place& place) {
    add_cells(cells, types, 0, vertices_.size() / 3, place, elements_);
  }

  void grid() {
    if (grid_.count() > 0) source_.fail("CELLS for the second time");
    grid_start_ = source_.place().position;
    grid_ = cells();
  }

  void cell_types() {
    const std::int64_t given = source_.text_integer("number of cell types");
    source_.line();
    const int count =
        source_.checked_count(given, "number of cell types", bytes_of(Scalar::int32), source_.place());
    types_ = source_.integers(Scalar::int32, static_cast<std::size_t>(count), "cell type");
  }

  VtkCells cells() {
    if (!has_points_) source_.fail("cells before POINTS");
    const Place place = source_.place();
    VtkCells cells = offset_layout_ ? cells_with_offsets() : cells_with_counts();
    require_offsets(cells, place);
    return cells;
  }

  // Up to version 4: the number of cells and of integers; then every cell, its number of points in front.
  VtkCells cells_with_counts() {
    const int count = source_.text_count("number of cells", bytes_of(Scalar::int32));
    int left = source_.text_count("number of integers", bytes_of(Scalar::int32));
    source_.line();
    if (count > left) source_.fail("more cells than integers");
    VtkCells cells;
    cells.offsets.reserve(static_cast<std::size_t>(count) + 1);
    cells.connectivity.reserve(static_cast<std::size_t>(left - count));
    cells.offsets.push_back(0);
    for (int c = 0; c < count; ++c) {
      const std::int64_t points = source_.integer(Scalar::int32, "number of points of a cell");
      if (points < 0 || points >= left)
        source_.fail("cell " + std::to_string(c) + " of " + std::to_string(points) + " points with " +
                     std::to_string(left - 1) + " integers left");
      for (std::int64_t p = 0; p < points; ++p)
        cells.connectivity.push_back(source_.integer(Scalar::int32, "point index"));
      cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
      left -= static_cast<int>(points) + 1;
    }
    if (left != 0) source_.fail(std::to_string(left) + " integers follow the last cell");
    return cells;
  }

  // From version 5: the lengths of two arrays, which follow.
  VtkCells cells_with_offsets() {
    const int offsets = source_.text_count("number of offsets", 2);
    const int points = source_.text_count("length of the connectivity", 2);
    source_.line();
    VtkCells cells;
    if (offsets == 0) return cells;
    cells.offsets = array("offsets", offsets);
    cells.connectivity = array("connectivity", points);
    return cells;
  }

  std::vector<std::int64_t> array(const char* keyword, int count) {
    if (lower(source_.word()) != keyword) source_.fail(std::string(keyword) + " expected");
    const Scalar number = type();
    if (is_real(number)) source_.fail(std::string(keyword) + " are not of an integer type");
    const Place place = source_.place();
    source_.line();
    source_.checked_count(count, keyword, bytes_of(number), place);
    return source_.integers(number, static_cast<std::size_t>(count), keyword);
  }

  // Ends with an empty line.
  void skip_metadata() {
    source_.line();
    while (source_.left() > 0 && !source_.line().empty()) {
    }
  }

  void skip_field() {
    source_.word();  // its name
    for (int arrays = source_.text_count("number of arrays", 8); arrays > 0; --arrays) skip_array();
  }

  void skip_array() {
    source_.word();  // its name
    const int components = source_.text_count("number of components", 1);
    const int tuples = source_.text_count("number of tuples", 1);
    const Place place = source_.place();
    const Scalar number = type();
    source_.line();
    const std::int64_t count = std::int64_t{components} * tuples;
    source_.checked_count(count, "length of an array", bytes_of(number), place);
    if (source_.binary()) {
      source_.bytes(static_cast<std::size_t>(count) * size_of(number), "array");
      return;
    }
    for (std::int64_t i = 0; i < count; ++i)
      if (source_.word().empty()) source_.fail("the file ends within an array");
  }

  static constexpr int no_type = 0;

  Source source_;
  ElementList elements_;
  bool offset_layout_ = false;
  bool has_points_ = false;
  std::vector<double> vertices_;
  VtkCells grid_;
  std::vector<std::int64_t> types_;
  std::size_t grid_start_ = 0;
};

}  // namespace

SurfaceMesh parse_vtk_surface(std::string_view contents, const std::string& name,
                              const ReadOptions& options) {
  return surface_of(VtkReader(contents, name, Shape::face, options).read());
}

TetMesh parse_vtk_tets(std::string_view contents, const std::string& name, const ReadOptions& options) {
  return tets_of(VtkReader(contents, name, Shape::tet, options).read());
}

SurfaceMesh read_vtk_surface(const std::string& path, const ReadOptions& options) {
  return parse_vtk_surface(read_file(path), path, options);
}

TetMesh read_vtk_tets(const std::string& path, const ReadOptions& options) {
  return parse_vtk_tets(read_file(path), path, options);
}

}  // namespace isostretch::mesh
