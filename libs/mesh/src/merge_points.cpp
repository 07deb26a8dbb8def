#include <isostretch/mesh/weld.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace isostretch::mesh {
namespace {

using Cell = std::array<double, 3>;

// Points by cell of a grid; with tolerance 0 a cell is a point. Open addressing on the hash of the cell, one
// slot a point: points of a cell follow each other.
class Grid {
 public:
  Grid(double tolerance, std::vector<double>& points)
      : tolerance_(tolerance), points_(points), slots_(64, -1) {}

  // A kept point that `point` is to be taken for, or -1.
  int find(const double* point) const {
    const Cell centre = cell(point);
    if (tolerance_ == 0) return find_in(centre, point);
    int best = -1;
    for (int i = 0; i < 27; ++i) {
      const Cell near = {centre[0] + i % 3 - 1, centre[1] + i / 3 % 3 - 1, centre[2] + i / 9 - 1};
      const int found = find_in(near, point);
      if (found >= 0 && (best < 0 || found < best)) best = found;
    }
    return best;
  }

  void keep(const double* point) {
    points_.insert(points_.end(), point, point + 3);
    if (2 * count() > slots_.size()) grow();
    insert(static_cast<int>(count()) - 1);
  }

 private:
  std::size_t count() const { return points_.size() / 3; }
  const double* kept(int index) const { return points_.data() + 3 * static_cast<std::size_t>(index); }

  // Where the tolerance is below what tells neighbours apart, every number is a cell of its own.
  double cell(double x) const {
    if (tolerance_ == 0) return x + 0.0;  // -0.0 becomes 0.0
    const double ratio = x / tolerance_;
    return std::abs(ratio) < 0x1p52 ? std::floor(ratio) : x;
  }
  Cell cell(const double* p) const { return {cell(p[0]), cell(p[1]), cell(p[2])}; }

  static std::size_t hash(const Cell& cell) {
    std::uint64_t h = 0;
    for (const double c : cell) {
      h = (h ^ std::bit_cast<std::uint64_t>(c + 0.0)) * 0x9E3779B97F4A7C15u;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }

  bool within_reach(const double* a, const double* b) const {
    if (tolerance_ == 0) return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) <= tolerance_;
  }

  int find_in(const Cell& wanted, const double* point) const {
    int best = -1;
    for (std::size_t s = first_slot(wanted); slots_[s] >= 0; s = next_slot(s))
      if ((best < 0 || slots_[s] < best) && within_reach(kept(slots_[s]), point)) best = slots_[s];
    return best;
  }

  void insert(int index) {
    std::size_t s = first_slot(cell(kept(index)));
    while (slots_[s] >= 0) s = next_slot(s);
    slots_[s] = index;
  }

  void grow() {
    slots_.assign(2 * slots_.size(), -1);
    for (std::size_t i = 0; i + 1 < count(); ++i) insert(static_cast<int>(i));
  }

  std::size_t first_slot(const Cell& cell) const { return hash(cell) & (slots_.size() - 1); }
  std::size_t next_slot(std::size_t slot) const { return (slot + 1) & (slots_.size() - 1); }

  double tolerance_;
  std::vector<double>& points_;
  std::vector<int> slots_;
};

}  // namespace

WeldedPoints weld(const std::vector<double>& points, double tolerance) {
  WeldedPoints welded;
  welded.index.reserve(points.size() / 3);
  Grid grid(tolerance, welded.points);
  for (std::size_t i = 0; i < points.size(); i += 3) {
    int index = grid.find(points.data() + i);
    if (index < 0) {
      index = static_cast<int>(welded.points.size() / 3);
      grid.keep(points.data() + i);
    }
    welded.index.push_back(index);
  }
  return welded;
}

}  // namespace isostretch::mesh
