#include "boundary_shape.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <string>

namespace isostretch::parameterization {
namespace {

// Shares of the whole that the edges along a piece of boundary take. Vertices that coincide in space must not
// coincide there, and no edge takes more than `most`.
std::vector<double> shares(const mesh::Points3& vertices, const std::vector<int>& path, double most) {
  const std::size_t n = path.size() - 1;
  std::vector<double> share(n);
  for (std::size_t i = 0; i < n; ++i)
    share[i] = mesh::length(mesh::edge_vector(vertices, path[i], path[i + 1]));
  const double total = std::accumulate(share.begin(), share.end(), 0.0), even = 1.0 / static_cast<double>(n);
  for (double& s : share) s = total > 0 ? std::clamp(s / total, 1e-6 * even, std::max(most, even)) : even;
  const double sum = std::accumulate(share.begin(), share.end(), 0.0);
  for (double& s : share) s /= sum;
  return share;
}

void place_on_circle(const mesh::Points3& vertices, std::vector<int> path, mesh::Points2& uv) {
  path.push_back(path.front());
  const std::vector<double> share = shares(vertices, path, 0.4);  // an edge of half the circle is a diameter
  double twice_area = 0, angle = 0;
  for (std::size_t i = 0; i < share.size(); ++i) {
    uv.row(path[i]) << std::cos(angle), std::sin(angle);
    const double step = 2 * std::numbers::pi * share[i];
    twice_area += std::sin(step);
    angle += step;
  }
  path.pop_back();
  const double radius = 1 / std::sqrt(0.5 * twice_area);
  for (const int vertex : path) uv.row(vertex) *= radius;
}

std::size_t farthest_from_middle(const mesh::Points3& vertices, const std::vector<int>& loop) {
  mesh::Vector3 middle{};
  for (const int v : loop)
    for (int d = 0; d < 3; ++d)
      middle[static_cast<std::size_t>(d)] += vertices(v, d) / static_cast<double>(loop.size());
  std::size_t best = 0;
  double farthest = -1;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const mesh::Vector3 r{vertices(loop[i], 0) - middle[0], vertices(loop[i], 1) - middle[1],
                          vertices(loop[i], 2) - middle[2]};
    if (mesh::length(r) > farthest) farthest = mesh::length(r), best = i;
  }
  return best;
}

// Turns the loop so that it begins with the first corner; returns where the corners are, and the end.
std::vector<std::size_t> given_corners(std::vector<int>& loop, const std::vector<int>& corners) {
  if (corners.size() != 4) throw Error(std::to_string(corners.size()) + " corners given: a square has four");
  const auto first = std::find(loop.begin(), loop.end(), corners[0]);
  if (first != loop.end()) std::rotate(loop.begin(), first, loop.end());
  std::vector<std::size_t> at;
  for (const int corner : corners) {
    const auto found = std::find(loop.begin(), loop.end(), corner);
    if (found == loop.end()) throw Error("corner " + std::to_string(corner) + " is not on the boundary");
    at.push_back(static_cast<std::size_t>(found - loop.begin()));
    if (at.size() > 1 && at[at.size() - 2] >= at.back())
      throw Error("corners must be different and follow the boundary with the surface on the left: vertex " +
                  std::to_string(corner) + " comes too late");
  }
  at.push_back(loop.size());
  return at;
}

std::vector<std::size_t> quarters(const mesh::Points3& vertices, std::vector<int>& loop) {
  if (loop.size() < 4)
    throw Error("the boundary has " + std::to_string(loop.size()) + " vertices, too few for a square");
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(farthest_from_middle(vertices, loop)),
              loop.end());
  std::vector<double> along{0};
  for (std::size_t i = 0; i < loop.size(); ++i)
    along.push_back(along.back() +
                    mesh::length(mesh::edge_vector(vertices, loop[i], loop[(i + 1) % loop.size()])));
  std::vector<std::size_t> at{0};
  for (std::size_t k = 1; k < 4; ++k) {
    const double target = along.back() * static_cast<double>(k) / 4;
    std::size_t best = at.back() + 1;
    // At least one vertex is left for each corner that follows.
    for (std::size_t i = best; i + (4 - k) <= loop.size(); ++i)
      if (std::abs(along[i] - target) < std::abs(along[best] - target)) best = i;
    at.push_back(best);
  }
  at.push_back(loop.size());
  return at;
}

void place_on_square(const mesh::Points3& vertices, std::vector<int> loop, const std::vector<int>& corners,
                     mesh::Points2& uv) {
  const std::vector<std::size_t> at =
      corners.empty() ? quarters(vertices, loop) : given_corners(loop, corners);
  constexpr double corner[4][2] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  for (std::size_t side = 0; side < 4; ++side) {
    std::vector<int> path(loop.begin() + static_cast<std::ptrdiff_t>(at[side]),
                          loop.begin() + static_cast<std::ptrdiff_t>(at[side + 1]));
    path.push_back(loop[at[side + 1] % loop.size()]);
    const std::vector<double> share = shares(vertices, path, 1.0);
    const double *from = corner[side], *to = corner[(side + 1) % 4];
    double t = 0;
    for (std::size_t i = 0; i < share.size(); ++i) {
      // The coordinate across is the same to the bit along a side.
      for (int d = 0; d < 2; ++d)
        uv(path[i], d) = from[d] == to[d] ? from[d] : from[d] + t * (to[d] - from[d]);
      t += share[i];
    }
  }
}

}  // namespace

void place_boundary(const mesh::Points3& vertices, const std::vector<int>& loop, const TutteOptions& options,
                    mesh::Points2& uv) {
  if (options.boundary == BoundaryShape::square)
    place_on_square(vertices, loop, options.corners, uv);
  else
    place_on_circle(vertices, loop, uv);
}

}  // namespace isostretch::parameterization
