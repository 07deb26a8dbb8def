
#include <isostretch/mesh/gather.hpp>
#include <isostretch/mesh/require.hpp>
#include <isostretch/surface/components.hpp>
#include <isostretch/surface/topology.hpp>

#include <algorithm>
#include <utility>

namespace isostretch::mesh {
namespace {

// Rows of vertices or uv that a part uses, in ascending order, and the part's triangles in terms of them.
// `number` is as long as the whole has rows and -1 everywhere, before and after.
std::vector<int> renumber(Triangles& triangles, std::vector<int>& number) {
  std::vector<int> used(triangles.data(), triangles.data() + triangles.size());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (std::size_t i = 0; i < used.size(); ++i)
    number[static_cast<std::size_t>(used[i])] = static_cast<int>(i);
  for (Eigen::Index i = 0; i < triangles.size(); ++i)
    triangles.data()[i] = number[static_cast<std::size_t>(triangles.data()[i])];
  for (const int row : used) number[static_cast<std::size_t>(row)] = -1;
  return used;
}

std::vector<std::vector<int>> triangles_by_label(const std::vector<int>& labels) {
  std::vector<std::vector<int>> triangles;
  for (std::size_t t = 0; t < labels.size(); ++t) {
    if (labels[t] < 0) throw Error("triangle " + std::to_string(t) + " has a negative label");
    if (static_cast<std::size_t>(labels[t]) >= triangles.size())
      triangles.resize(static_cast<std::size_t>(labels[t]) + 1);
    triangles[static_cast<std::size_t>(labels[t])].push_back(static_cast<int>(t));
  }
  return triangles;
}

}  // namespace

std::vector<int> component_of_triangles(const Triangles& triangles, int vertex_count) {
  require_indices(triangles, vertex_count, "triangle");
  UnionFind sets(vertex_count);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int c = 1; c < 3; ++c) sets.unite(triangles(t, 0), triangles(t, c));
  std::vector<int> number(static_cast<std::size_t>(vertex_count), -1);
  std::vector<int> component(static_cast<std::size_t>(triangles.rows()));
  int count = 0;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    int& known = number[static_cast<std::size_t>(sets.find(triangles(t, 0)))];
    if (known < 0) known = count++;
    component[static_cast<std::size_t>(t)] = known;
  }
  return component;
}

std::vector<Part> split(const SurfaceMesh& mesh) {
  return split(mesh, component_of_triangles(mesh.triangles, static_cast<int>(mesh.vertices.rows())));
}

std::vector<Part> split(const SurfaceMesh& mesh, const std::vector<int>& label_of_triangle) {
  if (label_of_triangle.size() != static_cast<std::size_t>(mesh.triangles.rows()))
    throw Error("there are " + std::to_string(mesh.triangles.rows()) + " triangles, but " +
                std::to_string(label_of_triangle.size()) + " labels");
  require_indices(mesh.triangles, mesh.vertices.rows(), "triangle");
  if (mesh.has_uv()) require_indices(mesh.uv_triangles, mesh.uv.rows(), "texture triangle");
  std::vector<int> number(static_cast<std::size_t>(std::max(mesh.vertices.rows(), mesh.uv.rows())), -1);
  std::vector<Part> parts;
  for (std::vector<int>& triangles : triangles_by_label(label_of_triangle)) {
    Part& part = parts.emplace_back();
    part.mesh.triangles = gather(mesh.triangles, triangles);
    part.original_vertex = renumber(part.mesh.triangles, number);
    part.mesh.vertices = gather(mesh.vertices, part.original_vertex);
    if (mesh.has_uv()) {
      part.mesh.uv_triangles = gather(mesh.uv_triangles, triangles);
      part.mesh.uv = gather(mesh.uv, renumber(part.mesh.uv_triangles, number));
    }
    part.original_triangle = std::move(triangles);
  }
  return parts;
}

SurfaceMesh merge(const std::vector<SurfaceMesh>& meshes) {
  Eigen::Index V = 0, F = 0, T = 0, uv_faces = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (meshes[i].has_uv() != meshes.front().has_uv())
      throw Error("cannot merge meshes 0 and " + std::to_string(i) +
                  ": only one of them has texture coordinates");
    V += meshes[i].vertices.rows();
    F += meshes[i].triangles.rows();
    T += meshes[i].uv.rows();
    uv_faces += meshes[i].uv_triangles.rows();
  }
  SurfaceMesh whole{Points3(V, 3), Triangles(F, 3), Points2(T, 2), Triangles(uv_faces, 3)};
  V = F = T = 0;
  for (const SurfaceMesh& mesh : meshes) {
    whole.vertices.middleRows(V, mesh.vertices.rows()) = mesh.vertices;
    whole.triangles.middleRows(F, mesh.triangles.rows()) = mesh.triangles.array() + static_cast<int>(V);
    whole.uv.middleRows(T, mesh.uv.rows()) = mesh.uv;
    if (mesh.has_uv())
      whole.uv_triangles.middleRows(F, mesh.triangles.rows()) =
          mesh.uv_triangles.array() + static_cast<int>(T);
    V += mesh.vertices.rows();
    F += mesh.triangles.rows();
    T += mesh.uv.rows();
  }
  return whole;
}

}  // namespace isostretch::mesh
