
#include <isostretch/mesh/measure.hpp>
#include <isostretch/mesh/require.hpp>
#include <isostretch/surface/boundary.hpp>
#include <isostretch/surface/topology.hpp>

#include <utility>

namespace isostretch::mesh {
namespace {

// vertex -> next boundary vertex, or -1.
std::vector<int> boundary_successors(const Triangles& triangles, int vertex_count) {
  std::vector<int> next(static_cast<std::size_t>(vertex_count), -1);
  for_each_edge(sorted_sides(triangles), [&](const Side* begin, const Side* end) {
    if (end - begin == 2 && begin[0].reversed == begin[1].reversed)
      throw Error("triangles " + std::to_string(begin[0].triangle) + " and " +
                  std::to_string(begin[1].triangle) + " are oriented against each other at edge " +
                  std::to_string(begin->low) + "-" + std::to_string(begin->high));
    if (end - begin > 2)
      throw Error("edge " + std::to_string(begin->low) + "-" + std::to_string(begin->high) + " belongs to " +
                  std::to_string(end - begin) + " triangles");
    if (end - begin == 2) return;
    int& successor = next[static_cast<std::size_t>(begin->from())];
    if (successor >= 0) throw Error("the boundary branches at vertex " + std::to_string(begin->from()));
    successor = begin->to();
  });
  return next;
}

}  // namespace

std::vector<std::vector<int>> boundary_loops(const Triangles& triangles, int vertex_count) {
  require_indices(triangles, vertex_count, "triangle");
  std::vector<int> next = boundary_successors(triangles, vertex_count);
  std::vector<std::vector<int>> loops;
  for (int start = 0; start < vertex_count; ++start) {
    if (next[static_cast<std::size_t>(start)] < 0) continue;
    std::vector<int>& loop = loops.emplace_back();
    // As many boundary edges enter a vertex as leave it, so the walk comes back to its start.
    for (int vertex = start; next[static_cast<std::size_t>(vertex)] >= 0;) {
      loop.push_back(vertex);
      vertex = std::exchange(next[static_cast<std::size_t>(vertex)], -1);
    }
  }
  return loops;
}

std::vector<std::vector<int>> boundary_loops(const SurfaceMesh& mesh) {
  return boundary_loops(mesh.triangles, static_cast<int>(mesh.vertices.rows()));
}

double loop_length(const SurfaceMesh& mesh, const std::vector<int>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += length(edge_vector(mesh.vertices, loop[i], loop[(i + 1) % loop.size()]));
  return sum;
}

std::size_t longest_loop(const SurfaceMesh& mesh, const std::vector<std::vector<int>>& loops) {
  if (loops.empty()) throw Error("the longest boundary loop of a surface without boundary");
  std::size_t longest = 0;
  double length = -1;
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (const double own = loop_length(mesh, loops[i]); own > length) length = own, longest = i;
  return longest;
}

}  // namespace isostretch::mesh
