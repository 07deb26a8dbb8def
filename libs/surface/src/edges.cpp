#include <isostretch/surface/edges.hpp>

#include <algorithm>

namespace isostretch::mesh {

Edges edges_of(const Triangles& triangles) {
  std::vector<std::array<int, 2>> all;
  all.reserve(static_cast<std::size_t>(triangles.size()));
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax(triangles(t, c), triangles(t, (c + 1) % 3));
      all.push_back({low, high});
    }
  std::sort(all.begin(), all.end());
  Edges edges;
  for (std::size_t i = 0, next = 0; i < all.size(); i = next) {
    while (next < all.size() && all[next] == all[i]) ++next;
    (next - i == 1 ? edges.boundary : edges.inner).push_back(all[i]);
  }
  return edges;
}

}  // namespace isostretch::mesh
