// mesh::find_overlap and what isostretch-parameterize writes, against constructions in exact numbers by CGAL.
#include "conditional.hpp"
#include "process.hpp"
#include "scratch.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/surface/overlap.hpp>

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/box_intersection_d.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <list>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace isostretch;
using namespace isostretch::test;
using isostretch::tests::outside_data;
using isostretch::tests::outside_path;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;
using Pairs = std::vector<std::array<int, 2>>;

struct Exact {
  Pairs pairs;
  std::list<Polygon> common;  // what two triangles have in common, of every pair
};

Polygon polygon(const mesh::Points2& uv, const mesh::Triangles& triangles, Eigen::Index t) {
  Polygon result;
  for (Eigen::Index c = 0; c < 3; ++c) result.push_back({uv(triangles(t, c), 0), uv(triangles(t, c), 1)});
  if (result.orientation() == CGAL::CLOCKWISE) result.reverse_orientation();
  return result;
}

// The part of a on the left of the line, corner by corner in exact numbers.
Polygon clipped(const Polygon& a, const Kernel::Line_2& line) {
  Polygon result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto &p = a[i], &q = a[(i + 1) % a.size()];
    const auto side_p = line.oriented_side(p), side_q = line.oriented_side(q);
    if (side_p != CGAL::ON_NEGATIVE_SIDE) result.push_back(p);
    if (side_p * side_q == -1) {
      const Kernel::FT at_p = line.a() * p.x() + line.b() * p.y() + line.c(),
                       at_q = line.a() * q.x() + line.b() * q.y() + line.c();
      result.push_back(p + (q - p) * (at_p / (at_p - at_q)));
    }
  }
  return result;
}

// Boxes that meet are found by CGAL as well. Triangles without area have no interior.
Exact exact(const mesh::Points2& uv, const mesh::Triangles& triangles) {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, int>;
  std::vector<Polygon> polygons;
  std::vector<Box> boxes;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    polygons.push_back(polygon(uv, triangles, t));
    if (polygons.back().orientation() != CGAL::COLLINEAR)
      boxes.emplace_back(polygons.back().bbox(), static_cast<int>(t));
  }
  Exact result;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const auto [i, j] = std::minmax({a.info(), b.info()});
    Polygon common = polygons[static_cast<std::size_t>(i)];
    for (auto e = polygons[static_cast<std::size_t>(j)].edges_begin();
         e != polygons[static_cast<std::size_t>(j)].edges_end() && common.size() > 2; ++e)
      common = clipped(common, e->supporting_line());
    if (common.size() < 3 || common.area() == 0) return;
    result.pairs.push_back({i, j});
    Polygon simple;  // without corners that coincide
    for (std::size_t k = 0; k < common.size(); ++k)
      if (common[k] != common[(k + 1) % common.size()]) simple.push_back(common[k]);
    result.common.push_back(simple);
  });
  std::sort(result.pairs.begin(), result.pairs.end());
  return result;
}

double area_of_union(const std::list<Polygon>& polygons) {
  CGAL::Polygon_set_2<Kernel> set;
  set.join(polygons.begin(), polygons.end());
  Kernel::FT area = 0;
  std::list<CGAL::Polygon_with_holes_2<Kernel>> parts;
  set.polygons_with_holes(std::back_inserter(parts));
  for (const auto& part : parts) {
    area += part.outer_boundary().area();
    for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole) area += hole->area();  // negative
  }
  return CGAL::to_double(area);
}

void compare(const mesh::Points2& uv, const mesh::Triangles& triangles) {
  const Exact expected = exact(uv, triangles);
  CHECK(mesh::overlapping_pairs(uv, triangles) == expected.pairs);
  const mesh::Overlap overlap = mesh::find_overlap(uv, triangles);
  std::set<int> concerned;
  for (const auto& pair : expected.pairs) concerned.insert(pair.begin(), pair.end());
  CHECK(overlap.triangles == std::vector<int>(concerned.begin(), concerned.end()));
  const double area = area_of_union(expected.common);
  CHECK(std::abs(overlap.overlapped_area - area) <= 1e-13 * (overlap.covered_area + area));
  std::list<Polygon> all;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    all.push_back(polygon(uv, triangles, t));
    if (all.back().orientation() == CGAL::COLLINEAR) all.pop_back();
  }
  CHECK(overlap.covered_area == doctest::Approx(area_of_union(all)).epsilon(1e-12));
}

mesh::SurfaceMesh flatten(const std::string& model, const std::vector<std::string>& options) {
  const Scratch scratch;
  std::vector<std::string> command = {model, "-o", scratch.path("out"), "--no-picture", "--quiet"};
  command.insert(command.end(), options.begin(), options.end());
  const Outcome run = parameterize(command);
  REQUIRE_MESSAGE(run.code == 0, run.err);
  return mesh::read_obj(scratch.path("out/" + std::filesystem::path(model).stem().string() + "_uv.obj"));
}

}  // namespace

TEST_CASE("random layouts: triangles anywhere, and grids shaken") {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> number(0, 1);
  for (int round = 0; round < 12; ++round) {
    mesh::Points2 uv(90, 2);
    for (Eigen::Index i = 0; i < uv.size(); ++i) uv.data()[i] = number(generator);
    mesh::Triangles triangles(30, 3);
    for (Eigen::Index i = 0; i < triangles.size(); ++i) triangles.data()[i] = static_cast<int>(i);
    compare(uv, triangles);
    const mesh::SurfaceMesh grid = mesh::grid(6, 6);
    uv = grid.vertices.leftCols(2);
    for (Eigen::Index i = 0; i < uv.size(); ++i)
      uv.data()[i] += 0.04 * (round + 1) * (number(generator) - 0.5);
    compare(uv, grid.triangles);
  }
}

TEST_CASE("degenerate contacts: corners on a small grid, so that edges and corners coincide") {
  std::mt19937 generator(12);
  std::uniform_int_distribution<int> place(0, 4);
  for (int round = 0; round < 40; ++round) {
    mesh::Points2 uv(24, 2);
    for (Eigen::Index i = 0; i < uv.size(); ++i) uv.data()[i] = place(generator);
    mesh::Triangles triangles(16, 3);
    std::uniform_int_distribution<int> corner(0, 23);
    for (Eigen::Index i = 0; i < triangles.size(); ++i) triangles.data()[i] = corner(generator);
    compare(uv, triangles);
    compare(uv * 0.1, triangles);  // the same, rounded
  }
}

TEST_CASE("almost degenerate contacts: corners moved by a few units in the last place") {
  std::mt19937 generator(13);
  std::uniform_int_distribution<int> place(0, 4), ulps(-2, 2);
  for (int round = 0; round < 40; ++round) {
    mesh::Points2 uv(24, 2);
    for (Eigen::Index i = 0; i < uv.size(); ++i)
      uv.data()[i] = 1 + place(generator) + ulps(generator) * 4.44e-16;
    mesh::Triangles triangles(16, 3);
    for (Eigen::Index i = 0; i < triangles.size(); ++i)
      triangles.data()[i] = static_cast<int>((7 * i + round) % 24);
    compare(uv, triangles);
  }
}

TEST_CASE("layouts of given models that overlap, before they are split" * outside_data({"meshes/disks"})) {
  for (const char* name : {"meshes/disks/bunnycut_19k.obj", "meshes/disks/camelb_up1_14k.obj"}) {
    const mesh::SurfaceMesh result = flatten(outside_path(name), {"--overlap", "allow"});
    const Exact expected = exact(result.uv, result.uv_triangles);
    CHECK(!expected.pairs.empty());
    CHECK(mesh::overlapping_pairs(result.uv, result.uv_triangles) == expected.pairs);
    CHECK(mesh::find_overlap(result.uv, result.uv_triangles).overlapped_area ==
          doctest::Approx(area_of_union(expected.common)).epsilon(1e-9));
  }
}

TEST_CASE("by default nothing overlaps" * outside_data({"meshes/disks", "meshes/surfaces"})) {
  std::vector<std::pair<std::string, std::vector<std::string>>> runs;
  for (const char* name :
       {"armadillocut_62k", "bunnycut_19k", "camelb_up1_14k", "camelhead_23k", "face_52k", "lilium_6k"})
    runs.push_back({"meshes/disks/" + std::string(name) + ".obj", {}});
  for (const char* name : {"cow.obj", "decimated-max.obj", "fertility.off", "spot.obj"})
    runs.push_back({"meshes/surfaces/" + std::string(name), {"--repair", "--pack", "square"}});
  runs.push_back({"meshes/surfaces/spot.obj", {"--no-input-seams", "--max-distortion", "1.5"}});
  for (const auto& [name, options] : runs) {
    CAPTURE(name);
    const mesh::SurfaceMesh result = flatten(outside_path(name), options);
    CHECK(exact(result.uv, result.uv_triangles).pairs.empty());
  }
}
