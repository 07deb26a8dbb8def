#include "vtk_cells.hpp"

#include "source.hpp"

#include <utility>

namespace isostretch::mesh {
namespace {

constexpr int pixel = 8;
constexpr int quadrangle = 9;

Shape shape_of(std::int64_t type) {
  if (type >= vtk_triangle && type <= quadrangle) return Shape::face;
  return type == vtk_tet ? Shape::tet : Shape::other;
}

// The cells of one file, one after the other.
class CellAdder {
 public:
  CellAdder(const VtkCells& cells, int first_point, std::size_t point_count, const Place& place,
            ElementList& elements)
      : cells_(cells),
        first_point_(first_point),
        point_count_(point_count),
        place_(place),
        elements_(elements) {}

  void add(std::size_t cell, std::int64_t type) {
    const Shape shape = shape_of(type);
    if (!elements_.wants(shape)) {
      elements_.skip(shape);
      return;
    }
    take_points(cell);
    // The corners of a pixel are numbered row by row.
    if (type == pixel && points_.size() == 4) std::swap(points_[2], points_[3]);
    if (type == vtk_triangle_strip)
      add_strip(cell);
    else
      add_element(cell);
  }

 private:
  void take_points(std::size_t cell) {
    points_.clear();
    for (std::int64_t i = cells_.offsets[cell]; i < cells_.offsets[cell + 1]; ++i) {
      const std::int64_t given = cells_.connectivity[static_cast<std::size_t>(i)];
      if (given < 0 || static_cast<std::uint64_t>(given) >= point_count_)
        fail(cell, out_of_range("point index", given, point_count_));
      points_.push_back(first_point_ + static_cast<int>(given));
    }
  }

  void add_element(std::size_t cell) {
    const std::string fault = elements_.fault(static_cast<std::int64_t>(points_.size()));
    if (!fault.empty()) fail(cell, fault);
    elements_.add(points_);
  }

  // Every other triangle of a strip runs the other way round.
  void add_strip(std::size_t cell) {
    if (points_.size() < 3) fail(cell, "strip with " + std::to_string(points_.size()) + " vertices");
    for (std::size_t i = 2; i < points_.size(); ++i) {
      const bool turned = i % 2 == 1;
      triangle_ = {points_[i - 2], points_[turned ? i : i - 1], points_[turned ? i - 1 : i]};
      elements_.add(triangle_);
    }
  }

  [[noreturn]] void fail(std::size_t cell, const std::string& what) const {
    place_.fail("cell " + std::to_string(cell) + ": " + what);
  }

  const VtkCells& cells_;
  int first_point_;
  std::size_t point_count_;
  const Place& place_;
  ElementList& elements_;
  std::vector<int> points_;  // of the cell being added
  std::vector<int> triangle_;
};

}  // namespace

void require_offsets(const VtkCells& cells, const Place& place) {
  std::int64_t before = 0;
  for (const std::int64_t offset : cells.offsets) {
    if (offset < before)
      place.fail("offset " + std::to_string(offset) + " of a cell is below the one before");
    before = offset;
  }
  if (!cells.offsets.empty() && cells.offsets.front() != 0)
    place.fail("offsets begin with " + std::to_string(cells.offsets.front()) + " instead of 0");
  if (static_cast<std::size_t>(before) != cells.connectivity.size())
    place.fail("offsets end at " + std::to_string(before) + ", there are " +
               std::to_string(cells.connectivity.size()) + " numbers in the cells");
}

void add_cells(const VtkCells& cells, const std::vector<std::int64_t>& types, int first_point,
               std::size_t point_count, const Place& place, ElementList& elements) {
  CellAdder adder(cells, first_point, point_count, place, elements);
  for (std::size_t c = 0; c < cells.count(); ++c) adder.add(c, types[c]);
}

}  // namespace isostretch::mesh
