#pragma once

#include <isostretch/mesh/io.hpp>
#include <isostretch/mesh/types.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace isostretch::mesh {

// What a reader makes of an element.
enum class Shape { face, tet, other };

// Elements of a file that may hold several kinds. Those asked for are kept, the rest is only counted.
class ElementList {
 public:
  ElementList(Shape wanted, const ReadOptions& options) : wanted_(wanted), options_(options) {}

  bool wants(Shape shape) const { return shape == wanted_; }
  // Why an element of so many corners is not taken; empty if it is.
  std::string fault(std::int64_t corners) const;
  // A wanted one without fault, its vertices from 0.
  void add(const std::vector<int>& corners);
  void skip(Shape shape, long count = 1) { skipped_[static_cast<std::size_t>(shape)] += count; }

  bool empty() const { return corners_.empty(); }
  // What to say of a file without any that were wanted.
  std::string missing() const;
  const std::vector<int>& corners() const { return corners_; }

 private:
  Shape wanted_;
  const ReadOptions& options_;
  std::vector<int> corners_;
  long skipped_[3] = {0, 0, 0};
};

struct MixedMesh {
  std::vector<double> vertices;
  ElementList elements;
};

SurfaceMesh surface_of(const MixedMesh& mesh);
TetMesh tets_of(const MixedMesh& mesh);

}  // namespace isostretch::mesh
