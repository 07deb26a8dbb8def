// Cutting, charts, packing and constraints on whole layouts, through the app.
#include "conditional.hpp"
#include "process.hpp"
#include "scratch.hpp"

#include "meshes.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/surface/boundary.hpp>
#include <isostretch/surface/components.hpp>
#include <isostretch/surface/cut.hpp>
#include <isostretch/surface/orientation.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::test;
using isostretch::tests::outside_data;
using isostretch::tests::outside_path;

namespace {

struct Result {
  nlohmann::json summary;
  mesh::SurfaceMesh mesh;
};

Result flatten(const Scratch& scratch, const mesh::SurfaceMesh& model,
               std::vector<std::string> options = {}) {
  mesh::write_obj(scratch.path("model.obj"), model);
  std::vector<std::string> command = {scratch.path("model.obj"), "-o", scratch.path("out"), "--no-picture",
                                      "--quiet"};
  command.insert(command.end(), options.begin(), options.end());
  const Outcome run = parameterize(command);
  REQUIRE_MESSAGE(run.code == 0, run.err);
  Result result{read_json(scratch.path("out/summary.json")),
                mesh::read_obj(scratch.path("out/model_uv.obj"))};
  CHECK(result.summary["flipped"] == 0);
  CHECK(mesh::count_flipped(result.mesh.uv, result.mesh.uv_triangles) == 0);
  return result;
}

mesh::SurfaceMesh two_balls_and_a_disc() {
  mesh::SurfaceMesh small = mesh::icosphere(2), disc = mesh::disc(6);
  small.vertices = (small.vertices * 0.4).rowwise() + Eigen::RowVector3d(3, 0, 0);
  disc.vertices = disc.vertices.rowwise() + Eigen::RowVector3d(-4, 0, 0);
  return mesh::merge({mesh::icosphere(3), small, disc});
}

// Charts of the layout do not overlap: their boxes are apart after packing.
void check_boxes_apart(const Result& result) {
  const auto label =
      mesh::component_of_triangles(result.mesh.uv_triangles, static_cast<int>(result.mesh.uv.rows()));
  const int charts = *std::max_element(label.begin(), label.end()) + 1;
  std::vector<std::array<double, 4>> boxes(static_cast<std::size_t>(charts), {2, 2, -2, -2});
  for (Eigen::Index t = 0; t < result.mesh.uv_triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c) {
      auto& box = boxes[static_cast<std::size_t>(label[static_cast<std::size_t>(t)])];
      for (std::size_t d = 0; d < 2; ++d) {
        const double at = result.mesh.uv(result.mesh.uv_triangles(t, c), static_cast<Eigen::Index>(d));
        box[d] = std::min(box[d], at);
        box[d + 2] = std::max(box[d + 2], at);
      }
    }
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto &a = boxes[i], &b = boxes[j];
      CHECK((a[0] > b[2] || b[0] > a[2] || a[1] > b[3] || b[1] > a[3]));
    }
}

mesh::SurfaceMesh shuffled(const mesh::SurfaceMesh& model, unsigned seed) {
  std::mt19937 generator(seed);
  const auto shuffle = [&](Eigen::Index n) {
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), generator);
    return order;
  };
  mesh::SurfaceMesh result = model;
  const auto vertex = shuffle(model.vertices.rows()), triangle = shuffle(model.triangles.rows()),
             point = shuffle(model.uv.rows());
  for (std::size_t v = 0; v < vertex.size(); ++v)
    result.vertices.row(vertex[v]) = model.vertices.row(static_cast<Eigen::Index>(v));
  for (std::size_t p = 0; p < point.size(); ++p)
    result.uv.row(point[p]) = model.uv.row(static_cast<Eigen::Index>(p));
  for (std::size_t t = 0; t < triangle.size(); ++t)
    for (int c = 0; c < 3; ++c) {
      const int from = (c + static_cast<int>(seed)) % 3;
      result.triangles(triangle[t], c) =
          vertex[static_cast<std::size_t>(model.triangles(static_cast<Eigen::Index>(t), from))];
      if (model.has_uv())
        result.uv_triangles(triangle[t], c) =
            point[static_cast<std::size_t>(model.uv_triangles(static_cast<Eigen::Index>(t), from))];
    }
  return result;
}

}  // namespace

TEST_CASE("several components become charts, packed into the unit square at one scale") {
  const Scratch scratch;
  const Result result = flatten(scratch, two_balls_and_a_disc());
  CHECK(result.summary["mesh"]["components"] == 3);
  CHECK(result.summary["layout"]["charts"] == 3);
  CHECK(result.summary["layout"]["packed"] == true);
  CHECK(result.mesh.uv.minCoeff() > 0);
  CHECK(result.mesh.uv.maxCoeff() < 1);
  check_boxes_apart(result);
  const double area = mesh::orientation(result.mesh.uv, result.mesh.uv_triangles).total_area;
  CHECK(area == doctest::Approx(result.summary["layout"]["coverage"].get<double>()));
  double energy = 0;
  for (const auto& chart : result.summary["charts"]) energy += chart["energy"].get<double>();
  CHECK(energy == doctest::Approx(result.summary["energy"].get<double>()));
  const Result kept = flatten(scratch, two_balls_and_a_disc(), {"--pack", "none", "--uv-units", "model"});
  CHECK(kept.summary["layout"]["uv_per_length"] == 1.0);
  CHECK(kept.summary["energy"].get<double>() == result.summary["energy"].get<double>());
}

TEST_CASE("handles and holes: genus 3 becomes one disk, short loops stay holes unless told") {
  const Scratch scratch;
  const Result slab = flatten(scratch, mesh::test::slab(3, 2));
  CHECK(slab.summary["mesh"]["genus"] == 3);
  CHECK(slab.summary["layout"]["charts"] == 1);
  CHECK(mesh::boundary_loops(slab.mesh.uv_triangles, static_cast<int>(slab.mesh.uv.rows())).size() == 1);

  mesh::SurfaceMesh ring = mesh::disc(8);
  std::vector<int> outer;
  for (int t = 0; t < ring.triangles.rows(); ++t)
    if (!(ring.triangles.row(t).array() == 0).any()) outer.push_back(t);
  const mesh::Triangles all = ring.triangles;
  ring.triangles.resize(std::ssize(outer), 3);
  for (std::size_t t = 0; t < outer.size(); ++t)
    ring.triangles.row(static_cast<Eigen::Index>(t)) = all.row(outer[t]);
  const Result open = flatten(scratch, ring), cut = flatten(scratch, ring, {"--holes", "none"});
  CHECK(open.summary["layout"]["cut_edges"] == 0);
  CHECK(open.summary["energy"].get<double>() == doctest::Approx(4));
  CHECK(cut.summary["layout"]["cut_edges"].get<int>() > 0);
}

TEST_CASE("seams of the input are respected, or ignored when told") {
  const Scratch scratch;
  const Result first = flatten(scratch, mesh::icosphere(3), {"--cut-tips", "2"});
  const Result again = flatten(scratch, first.mesh, {"--cut-tips", "2"});
  CHECK(again.summary["layout"]["cut_edges"] == first.summary["layout"]["cut_edges"]);
  CHECK(again.summary["energy"].get<double>() ==
        doctest::Approx(first.summary["energy"].get<double>()).epsilon(1e-8));
  const std::string cut = std::to_string(first.summary["layout"]["cut_edges"].get<int>());
  mesh::write_obj(scratch.path("seams.obj"), first.mesh);
  const Outcome said = parameterize({scratch.path("seams.obj"), "-o", scratch.path("said"), "--no-picture"});
  CHECK_MESSAGE(
      said.err.find("cut along the input's seams: " + cut + " edges, 1 chart\n") != std::string::npos,
      said.err);
  const Result anew = flatten(scratch, first.mesh, {"--no-input-seams"});
  CHECK(anew.summary["energy"].get<double>() < again.summary["energy"].get<double>());
}

TEST_CASE("a bound on the distortion is met by further cuts") {
  const Scratch scratch;
  const Result ball = flatten(scratch, mesh::icosphere(3), {"--max-distortion", "1.5"});
  CHECK(ball.summary["layout"]["further_cuts"].get<int>() > 0);
  CHECK(ball.summary["distortion"]["max_sigma"].get<double>() <= 1.5);
  CHECK(ball.summary["distortion"]["min_sigma"].get<double>() >= 1 / 1.5);
  mesh::write_obj(scratch.path("ball.obj"), mesh::icosphere(3));
  const Outcome too_few = parameterize({scratch.path("ball.obj"), "-o", scratch.path("few"), "--no-picture",
                                        "--max-distortion", "1.2", "--max-cuts", "2"});
  CHECK(too_few.code == 5);
  CHECK(too_few.err.find("the largest distortion is") != std::string::npos);
}

TEST_CASE("a bound is met and the status is that of the last solve of every chart") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("face.obj"), mesh::procedural_face(6));
  const Outcome run = parameterize({scratch.path("face.obj"), "-o", scratch.path("out"), "--no-picture",
                                    "--max-distortion", "1.2", "--max-iterations", "30"});
  const auto summary = read_json(scratch.path("out/summary.json"));
  bool all_converged = true;
  for (const auto& chart : summary["charts"])
    all_converged = all_converged && chart["status"].get<std::string>().rfind("converged", 0) == 0;
  CHECK(all_converged == summary["converged"].get<bool>());
  CHECK_MESSAGE(run.code == (all_converged ? 0 : 5), run.err);
}

TEST_CASE("every linear solver flattens") {
  const Scratch scratch;
  const double energy = flatten(scratch, mesh::procedural_face(8)).summary["energy"].get<double>();
  for (const char* solver : {"eigen_ldlt", "pcg"}) {
    CAPTURE(solver);
    CHECK(flatten(scratch, mesh::procedural_face(8), {"--backend", solver}).summary["energy"].get<double>() ==
          doctest::Approx(energy).epsilon(1e-8));
  }
}

TEST_CASE("the boundary on a circle, on a square, fixed") {
  const Scratch scratch;
  const mesh::SurfaceMesh face = mesh::procedural_face(8);
  const std::vector<int> loop = mesh::boundary_loops(face).front();
  const double free = flatten(scratch, face).summary["energy"].get<double>();
  const std::vector<std::string> in_place = {"--uv-units", "model", "--pack", "none", "--boundary"};
  const auto held = [&](std::vector<std::string> how) {
    how.insert(how.begin(), in_place.begin(), in_place.end());
    return flatten(scratch, face, how);
  };
  const Result circle = held({"circle"});
  const double radius = circle.mesh.uv.row(loop[0]).norm();
  for (const int v : loop) CHECK(circle.mesh.uv.row(v).norm() == doctest::Approx(radius).epsilon(1e-12));
  CHECK(circle.summary["energy"].get<double>() > free);
  std::string corners;
  for (const std::size_t i : {std::size_t{3}, loop.size() / 3, loop.size() / 2, loop.size() - 2})
    corners.append(corners.empty() ? "" : ",").append(std::to_string(loop[i]));
  const Result square = held({"square", "--corners", corners});
  const double side = square.mesh.uv.maxCoeff();
  for (const int v : loop)
    CHECK(std::max(std::abs(square.mesh.uv(v, 0)), std::abs(square.mesh.uv(v, 1))) == doctest::Approx(side));
  const Result fixed = flatten(scratch, circle.mesh, {"--initial", "input", "--boundary", "fixed"});
  for (const int v : loop) CHECK((fixed.mesh.uv.row(v) - circle.mesh.uv.row(v)).norm() < 1e-12);

  SUBCASE("what cannot be is explained") {
    // A corner triangle has two edges on one side of the square unless its vertex is a corner.
    mesh::write_obj(scratch.path("grid.obj"), mesh::grid(3, 3));
    const Outcome run = parameterize({scratch.path("grid.obj"), "-o", scratch.path("no"), "--boundary",
                                      "square", "--corners", "1,2,7,11"});
    CHECK(run.code != 0);
    CAPTURE(run.err);
    CHECK((run.err.find("corners on the boundary that is held") != std::string::npos ||
           run.err.find("comes too late") != std::string::npos));
  }
}

TEST_CASE("aligned vertices lie on a line to the bit") {
  const Scratch scratch;
  const mesh::SurfaceMesh face = mesh::procedural_face(8);
  const std::vector<int> loop = mesh::boundary_loops(face).front();
  const auto list = [&](std::size_t a, std::size_t b, std::size_t c) {
    return std::to_string(loop[a]) + "," + std::to_string(loop[b]) + "," + std::to_string(loop[c]);
  };
  const Result result =
      flatten(scratch, face, {"--horizontal", list(0, 1, 2), "--vertical", list(20, 21, 22)});
  for (const std::size_t i : {1u, 2u}) CHECK(result.mesh.uv(loop[i], 1) == result.mesh.uv(loop[0], 1));
  for (const std::size_t i : {21u, 22u}) CHECK(result.mesh.uv(loop[i], 0) == result.mesh.uv(loop[20], 0));
  CHECK(result.summary["energy"].get<double>() >= flatten(scratch, face).summary["energy"].get<double>());

  // Lines that share a vertex are one line.
  const Result joined =
      flatten(scratch, face, {"--horizontal", list(0, 1, 2), "--horizontal", list(2, 3, 4)});
  for (const std::size_t i : {1u, 2u, 3u, 4u})
    CHECK(joined.mesh.uv(loop[i], 1) == joined.mesh.uv(loop[0], 1));

  mesh::write_obj(scratch.path("face.obj"), face);
  const auto refuse = [&](std::vector<std::string> options, const std::string& words) {
    options.insert(options.begin(), {scratch.path("face.obj"), "-o", scratch.path("no")});
    const Outcome run = parameterize(options);
    CAPTURE(run.err);
    CHECK((run.code == 2 || run.code == 3));
    CHECK(run.err.find(words) != std::string::npos);
  };
  refuse({"--horizontal", "3"}, "names less than two vertices");
  refuse({"--horizontal", "3,99999"}, "99999");
  refuse({"--horizontal", "3,4", "--pin", "3:0,0", "--pin", "4:0.1,0.1"}, "pinned at different v");
}

TEST_CASE("order, scale and place of a model do not matter" * outside_data({"meshes/surfaces"})) {
  const Scratch scratch;
  for (const char* name : {"spot.obj", "cow.obj", "fertility.off", "decimated-max.obj"}) {
    CAPTURE(name);
    const mesh::SurfaceMesh model = mesh::read_surface(outside_path("meshes/surfaces/" + std::string(name)));
    const double energy = flatten(scratch, model, {"--repair"}).summary["energy"].get<double>();
    const double extent =
        (model.vertices.colwise().maxCoeff() - model.vertices.colwise().minCoeff()).maxCoeff();
    for (unsigned seed = 1; seed <= 4; ++seed) {
      CAPTURE(seed);
      mesh::SurfaceMesh other = shuffled(model, seed);
      if (seed == 2) other.vertices *= 1e-6;
      if (seed == 3) other.vertices *= 1e6;
      if (seed == 4) other.vertices.rowwise() += Eigen::RowVector3d(1e6, -1e6, 0.7e6) * extent;
      CHECK(flatten(scratch, other, {"--repair"}).summary["energy"].get<double>() ==
            doctest::Approx(energy).epsilon(1e-9));
    }
  }
}
