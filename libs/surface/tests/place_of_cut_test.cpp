// Where surfaces are cut: in the same place however they are numbered, scaled and moved, and up to their
// tips.
#include "conditional.hpp"
#include "cuts.hpp"
#include "meshes.hpp"

#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/surface/cut.hpp>
#include <isostretch/surface/repair.hpp>
#include <isostretch/surface/seams.hpp>

#include <doctest/doctest.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <string>
#include <vector>

using namespace isostretch::mesh;
using namespace isostretch::mesh::test;
using isostretch::tests::outside_data;
using isostretch::tests::outside_path;

namespace {

SurfaceMesh shuffled(const SurfaceMesh& mesh, unsigned seed, std::vector<int>& original_vertex) {
  std::mt19937 random(seed);
  std::vector<int> order(static_cast<std::size_t>(mesh.triangles.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  original_vertex.resize(static_cast<std::size_t>(mesh.vertices.rows()));
  std::iota(original_vertex.begin(), original_vertex.end(), 0);
  std::shuffle(original_vertex.begin(), original_vertex.end(), random);
  std::vector<int> number(original_vertex.size());
  SurfaceMesh result = mesh;
  for (std::size_t v = 0; v < number.size(); ++v) {
    number[original_vertex[v]] = static_cast<int>(v);
    result.vertices.row(static_cast<Eigen::Index>(v)) = mesh.vertices.row(original_vertex[v]);
  }
  for (std::size_t t = 0; t < order.size(); ++t)
    for (int c = 0, turn = static_cast<int>(random() % 3); c < 3; ++c)
      result.triangles(static_cast<Eigen::Index>(t), c) = number[mesh.triangles(order[t], (c + turn) % 3)];
  return result;
}

std::vector<Edge> renamed(const std::vector<Edge>& edges, const std::vector<int>& names) {
  std::vector<Edge> result;
  for (const Edge& edge : edges) {
    const auto [low, high] = std::minmax({names[edge.low], names[edge.high]});
    result.push_back({low, high});
  }
  std::sort(result.begin(), result.end());
  return result;
}

SurfaceMesh moved(SurfaceMesh mesh, double diameters) {
  const Eigen::RowVector3d size = mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff();
  mesh.vertices.rowwise() += diameters * size.norm() * Eigen::RowVector3d(0.3, -0.8, 0.5);
  return mesh;
}

void cuts_the_same_everywhere(const SurfaceMesh& mesh, const CutOptions& options = {}) {
  CAPTURE(mesh.triangles.rows());
  const std::vector<Edge> seams = cut_to_disks(mesh, options).seams;
  for (const double scale : {1e-6, 0.37, 1e6}) {
    CAPTURE(scale);
    SurfaceMesh scaled = mesh;
    scaled.vertices *= scale;
    CHECK(cut_to_disks(scaled, options).seams == seams);
  }
  for (const double diameters : {1.0, 1e3, 1e6}) {
    CAPTURE(diameters);
    CHECK(cut_to_disks(moved(mesh, diameters), options).seams == seams);
  }
  for (unsigned seed = 1; seed <= 4; ++seed) {
    CAPTURE(seed);
    std::vector<int> original;
    const SurfaceMesh other = shuffled(mesh, seed, original);
    CutOptions renamed_options = options;
    std::vector<int> number(original.size());
    for (std::size_t v = 0; v < original.size(); ++v) number[original[v]] = static_cast<int>(v);
    renamed_options.seams = renamed(options.seams, number);
    CHECK(renamed(cut_to_disks(other, renamed_options).seams, original) == seams);
  }
}

}  // namespace

TEST_CASE("cut: where does not depend on numbering, scale and place") {
  cuts_the_same_everywhere(icosphere(3), {.max_terminals = 6, .terminal_distance = 0.1});
  cuts_the_same_everywhere(tetrahedron());
  cuts_the_same_everywhere(octahedron());
  cuts_the_same_everywhere(torus(24, 12));
  cuts_the_same_everywhere(slab(0, 6), {.max_terminals = 8, .terminal_distance = 0.1});
  cuts_the_same_everywhere(slab(2, 4));
  cuts_the_same_everywhere(tube(30, 12));
  cuts_the_same_everywhere(plate_with_holes());
  cuts_the_same_everywhere(plate_with_holes(), {.holes = Holes::cut_all});
  cuts_the_same_everywhere(without(slab(1, 4), {8, 100, 200}), {.hole_fraction = 0.05});
}

TEST_CASE("cut: real surfaces" * outside_data({"meshes/surfaces"})) {
  struct Surface {
    std::string name;
    int genus;
    double longest;  // seam against the square root of the area
  };
  for (const Surface& surface : {Surface{"spot.obj", 0, 2.8}, Surface{"cow.obj", 0, 3.9},
                                 Surface{"fertility.off", 4, 3.5}, Surface{"decimated-max.obj", 0, 1.5}}) {
    CAPTURE(surface.name);
    SurfaceMesh mesh = read_surface(outside_path("meshes/surfaces/" + surface.name));
    repair(mesh, {.split_vertices = true});
    const Cut cut = cut_well(mesh);
    int genus = 0;
    double length = 0;
    for (const Chart& chart : cut.charts) {
      genus += chart.genus;
      length += chart.seam_length;
    }
    CHECK(genus == surface.genus);
    CHECK(length < surface.longest * std::sqrt(total_area(mesh)));
    cuts_the_same_everywhere(mesh);
  }
}

TEST_CASE("cut: a finger between others that are longer is reached") {
  // A ball with fingers: the short ones are no vertices far from the tree, but are curved.
  SurfaceMesh ball = icosphere(4);
  const Eigen::RowVector3d fingers[] = {{1, 0, 0}, {-1, 0.1, 0}, {0.1, 1, 0}, {0, 0.1, 1}, {0.7, -0.7, 0.1}};
  const auto tip_distance = [&](const Cut& cut, const Eigen::RowVector3d& direction) {
    Eigen::Index tip = 0;
    (ball.vertices * direction.normalized().transpose()).maxCoeff(&tip);
    double nearest = HUGE_VAL;
    for (const Edge& seam : cut.seams)
      nearest = std::min(nearest, (ball.vertices.row(seam.low) - ball.vertices.row(tip)).norm());
    return nearest;
  };
  for (Eigen::Index v = 0; v < ball.vertices.rows(); ++v) {
    double height = 1;
    for (const Eigen::RowVector3d& finger : fingers) {
      const double angle = std::acos(ball.vertices.row(v).dot(finger.normalized()));
      height += 1.2 * std::exp(-40 * angle * angle);
    }
    ball.vertices.row(v) *= height;
  }
  const Cut few = cut_to_disks(ball, {.max_terminals = 3, .tip_scale = 100}),
            all = cut_to_disks(ball, {.max_terminals = 7, .terminal_distance = 100});
  double farthest = 0;
  for (const Eigen::RowVector3d& finger : fingers) {
    CHECK(tip_distance(all, finger) < 0.4);
    farthest = std::max(farthest, tip_distance(few, finger));
  }
  CHECK(farthest > 0.5);
  cuts_the_same_everywhere(ball);
}
