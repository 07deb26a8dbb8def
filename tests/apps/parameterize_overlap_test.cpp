// Layouts that lie on themselves: found, said everywhere, and split away; and what the last line says.
#include "conditional.hpp"
#include "process.hpp"
#include "scratch.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/surface/components.hpp>
#include <isostretch/surface/overlap.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace isostretch;
using namespace isostretch::test;
using isostretch::tests::outside_data;
using isostretch::tests::outside_path;

namespace {

// A strip of two turns around an axis, rising: flat, it lies on itself all over.
mesh::SurfaceMesh two_turn_ramp() {
  constexpr int steps = 24;
  mesh::SurfaceMesh ramp;
  ramp.vertices.resize(2 * (steps + 1), 3);
  ramp.triangles.resize(2 * steps, 3);
  for (int i = 0; i <= steps; ++i)
    for (int side = 0; side < 2; ++side) {
      const double angle = 4 * std::numbers::pi * i / steps, radius = 1 + side;
      ramp.vertices.row(2 * i + side) << radius * std::cos(angle), radius * std::sin(angle), 0.1 * i / 12;
    }
  for (int i = 0; i < steps; ++i) {
    ramp.triangles.row(2 * i) << 2 * i, 2 * i + 1, 2 * i + 3;
    ramp.triangles.row(2 * i + 1) << 2 * i, 2 * i + 3, 2 * i + 2;
  }
  return ramp;
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  return text.substr(text.rfind('\n', end) + 1, end - text.rfind('\n', end));
}

// Ends of the cut inside the surface, by how many edges of the cut lead from there to where it branches or
// ends.
std::map<int, int> branches(const mesh::SurfaceMesh& result) {
  std::map<std::pair<int, int>, std::set<std::pair<int, int>>>
      uses;  // of an edge by vertices: its ends in uv
  std::map<std::pair<int, int>, int> triangles;
  for (Eigen::Index t = 0; t < result.triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3;
      std::pair<int, int> edge(result.triangles(t, c), result.triangles(t, d)),
          uv(result.uv_triangles(t, c), result.uv_triangles(t, d));
      if (edge.first > edge.second) std::swap(edge.first, edge.second), std::swap(uv.first, uv.second);
      uses[edge].insert(uv);
      ++triangles[edge];
    }
  std::map<int, std::set<int>> neighbours;
  for (const auto& [edge, uv] : uses)
    if (uv.size() == 2 || triangles[edge] == 1) {
      neighbours[edge.first].insert(edge.second);
      neighbours[edge.second].insert(edge.first);
    }
  std::map<int, int> count;
  for (const auto& [end, first] : neighbours) {
    if (first.size() != 1) continue;
    int before = end, at = *first.begin(), edges = 1;
    while (neighbours[at].size() == 2) {
      const int next = *neighbours[at].begin() == before ? *neighbours[at].rbegin() : *neighbours[at].begin();
      before = std::exchange(at, next);
      ++edges;
    }
    ++count[edges];
  }
  return count;
}

}  // namespace

TEST_CASE("overlap is said on stdout, in the summary, the report and a warning") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("ramp.obj"), two_turn_ramp());
  const Outcome run =
      parameterize({scratch.path("ramp.obj"), "-o", scratch.path("out"), "--overlap", "allow"});
  CHECK_MESSAGE(run.code == 0, run.err);
  CHECK(last_line(run.out).find("of the layout's area lies under more than one triangle") !=
        std::string::npos);
  CHECK(run.err.find("warning: the layout lies on itself: 48 triangles of 1 chart overlap") !=
        std::string::npos);
  const auto overlap = read_json(scratch.path("out/summary.json"))["layout"]["overlap"];
  CHECK(overlap["share"].get<double>() > 0.95);
  CHECK(overlap["triangles"] == 48);
  CHECK(overlap["charts"] == std::vector<int>{0});
  CHECK(!overlap.contains("split"));
  const std::string html = read_file(scratch.path("out/report.html"));
  for (const char* words :
       {"The layout lies on itself", "hatched in the picture", "under more than one triangle"})
    CHECK_MESSAGE(html.find(words) != std::string::npos, words);
}

TEST_CASE("by default a chart that lies on itself is split, and shapes stay") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("ramp.obj"), two_turn_ramp());
  const Outcome run = parameterize({scratch.path("ramp.obj"), "-o", scratch.path("out"), "--no-picture"}),
                allowed = parameterize({scratch.path("ramp.obj"), "-o", scratch.path("allowed"),
                                        "--no-picture", "--overlap", "allow"});
  CHECK_MESSAGE(run.code == 0, run.err);
  CHECK_MESSAGE(allowed.code == 0, allowed.err);
  CHECK(run.err.find("warning") == std::string::npos);
  CHECK(last_line(run.out).rfind("2 charts; no triangle is turned over; nothing overlaps; ", 0) == 0);
  const auto summary = read_json(scratch.path("out/summary.json"));
  const auto& overlap = summary["layout"]["overlap"];
  CHECK(overlap["triangles"] == 0);
  CHECK(overlap["share"] == 0);
  CHECK(overlap["split"]["share_before"].get<double>() > 0.95);
  CHECK(overlap["split"]["charts_added"] == 1);
  CHECK(overlap["split"]["cut_length"].get<double>() < 1.5);  // the strip is 1 wide
  CHECK(summary["charts"].size() == 2);
  for (const auto& chart : summary["charts"]) {
    CHECK(chart["split_from"] == 0);
    CHECK(chart["status"].get<std::string>().rfind("converged", 0) == 0);
  }
  CHECK(summary["distortion"] == read_json(scratch.path("allowed/summary.json"))["distortion"]);
  const mesh::SurfaceMesh result = mesh::read_obj(scratch.path("out/ramp_uv.obj"));
  CHECK(mesh::overlapping_pairs(result.uv, result.uv_triangles).empty());
  const double covered = mesh::find_overlap(result.uv, result.uv_triangles).covered_area;
  CHECK(covered == doctest::Approx(summary["layout"]["coverage"].get<double>()));
}

TEST_CASE("coverage counts area once") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("ramp.obj"), two_turn_ramp());
  CHECK(parameterize(
            {scratch.path("ramp.obj"), "-o", scratch.path("out"), "--no-picture", "--overlap", "allow"})
            .code == 0);
  const mesh::SurfaceMesh result = mesh::read_obj(scratch.path("out/ramp_uv.obj"));
  const auto layout = read_json(scratch.path("out/summary.json"))["layout"];
  CHECK(layout["coverage"].get<double>() ==
        doctest::Approx(mesh::find_overlap(result.uv, result.uv_triangles).covered_area));
  CHECK(layout["coverage"].get<double>() < 0.8);
}

TEST_CASE("charts that are left where they are lie on each other, and that is said") {
  const Scratch scratch;
  mesh::SurfaceMesh second = mesh::disc(4);
  second.vertices.col(2).array() += 5;
  mesh::write_obj(scratch.path("discs.obj"), mesh::merge({mesh::disc(4), second}));
  const Outcome run =
      parameterize({scratch.path("discs.obj"), "-o", scratch.path("out"), "--no-picture", "--pack", "none"});
  CHECK(run.err.find("lies on itself") != std::string::npos);
  CHECK(read_json(scratch.path("out/summary.json"))["layout"]["overlap"]["charts"] == std::vector<int>{0, 1});
}

TEST_CASE("an input's uv that is folded is found, with --initial input as well") {
  const Scratch scratch;
  mesh::SurfaceMesh grid = mesh::grid(4, 4);
  grid.uv = grid.vertices.leftCols(2);
  grid.uv_triangles = grid.triangles;
  for (Eigen::Index v = 0; v < grid.uv.rows(); ++v) grid.uv(v, 0) = std::abs(grid.uv(v, 0) - 0.5);
  mesh::write_obj(scratch.path("fold.obj"), grid);
  const Outcome run = parameterize({scratch.path("fold.obj"), "-o", scratch.path("out"), "--no-picture", "-e",
                                    "arap", "--initial", "input", "--max-iterations", "0"});
  CHECK(run.code == 6);
  CHECK(read_json(scratch.path("out/summary.json"))["layout"]["overlap"]["share"].get<double>() > 0.99);
}

TEST_CASE("options on overlap that contradict each other are refused") {
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--overlap", "split", "--no-cut"},
                                                  {"--overlap", "split", "--pack", "none"},
                                                  {"--overlap", "perhaps"}}) {
    std::vector<std::string> command = {"none.obj", "-o", "out"};
    command.insert(command.end(), options.begin(), options.end());
    const Outcome run = parameterize(command);
    CHECK(run.code == 2);
    CHECK(run.err.find("--overlap") != std::string::npos);
  }
}

TEST_CASE("the last line names no enumerators, --verbose has them") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("face.obj"), mesh::procedural_face(6));
  const Outcome run = parameterize({scratch.path("face.obj"), "-o", scratch.path("out"), "--no-picture"});
  CHECK(run.out.find('_' + std::string("gradient")) == std::string::npos);
  CHECK(last_line(run.out).find(
            "1 chart; no triangle is turned over; nothing overlaps; no length changes by more") == 0);
  CHECK(last_line(run.out).find("converged (") != std::string::npos);
  const Outcome verbose =
      parameterize({scratch.path("face.obj"), "-o", scratch.path("out"), "--no-picture", "-v"});
  CHECK(verbose.out.find("converged_scaled_gradient after") != std::string::npos);
  const Outcome stopped = parameterize(
      {scratch.path("face.obj"), "-o", scratch.path("out"), "--no-picture", "--max-iterations", "1"});
  CHECK(last_line(stopped.out).find("NOT converged: ") != std::string::npos);
  CHECK(stopped.err.find("stopped_") == std::string::npos);
}

TEST_CASE("a GLB has the layout as its texture coordinates") {
  const Scratch scratch;
  scratch.write("quad.obj",
                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.1 0.2\nvt 0.9 0.2\nvt 0.9 0.6\nvt 0.1 0.6\n"
                "f 1/1 2/2 3/3 4/4\n");
  CHECK(parameterize({scratch.path("quad.obj"), "-o", scratch.path("out"), "--no-picture", "--glb",
                      "--triangulate", "-q"})
            .code == 0);
  const std::string glb = read_file(scratch.path("out/quad_uv.glb"));
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, glb.data() + at, sizeof value);
    return value;
  };
  const auto json = nlohmann::json::parse(glb.substr(20, number(12)));
  const std::size_t data = 28 + number(12);
  const auto& attributes = json["meshes"][0]["primitives"][0]["attributes"];
  const auto read = [&](const nlohmann::json& index, int width) {
    const auto& accessor = json["accessors"][index.get<std::size_t>()];
    const auto& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    std::vector<float> values(accessor["count"].get<std::size_t>() * static_cast<std::size_t>(width));
    std::memcpy(values.data(), glb.data() + data + view["byteOffset"].get<std::size_t>(), 4 * values.size());
    return values;
  };
  const std::vector<float> position = read(attributes["POSITION"], 3), uv = read(attributes["TEXCOORD_0"], 2);
  const mesh::SurfaceMesh result = mesh::read_obj(scratch.path("out/quad_uv.obj"));
  REQUIRE(uv.size() == 8);
  int checked = 0;
  for (std::size_t v = 0; v < 4; ++v)
    for (Eigen::Index t = 0; t < 2; ++t)
      for (int c = 0; c < 3; ++c) {
        const auto p = result.vertices.row(result.triangles(t, c));
        if (p.x() != static_cast<double>(position[3 * v]) ||
            p.y() != static_cast<double>(position[3 * v + 1]))
          continue;
        ++checked;
        const auto q = result.uv.row(result.uv_triangles(t, c));
        CHECK(static_cast<double>(uv[2 * v]) == doctest::Approx(q.x()).epsilon(1e-6));
        CHECK(1 - static_cast<double>(uv[2 * v + 1]) == doctest::Approx(q.y()).epsilon(1e-6));
      }
  CHECK(checked == 6);
  for (const float coordinate : uv) CHECK((coordinate >= 0 && coordinate <= 1));
  const auto& texture = json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  CHECK(texture["extensions"]["KHR_texture_transform"]["scale"][0].get<double>() > 1);
}

TEST_CASE("closed models: tips are reached, and little is cut for it" * outside_data({"meshes/surfaces"})) {
  struct Model {
    const char* name;
    double worst, longest;  // factor of a length; cut over the square root of the area
  };
  // Cuts before were 5.43, 2.95 and 3.31 long.
  for (const Model& model : {Model{"spot.obj", 2.5, 1.6 * 5.43}, Model{"cow.obj", 3, 1.6 * 2.95},
                             Model{"fertility.off", 3, 1.6 * 3.31}}) {
    const std::string path = outside_path("meshes/surfaces/" + std::string(model.name));
    CAPTURE(path);
    const Scratch scratch;
    const Outcome run = parameterize(
        {path, "-o", scratch.path("out"), "--no-picture", "-q", "--repair", "--overlap", "allow"});
    CHECK_MESSAGE(run.code == 0, run.err);
    const auto summary = read_json(scratch.path("out/summary.json"));
    CHECK(summary["distortion"]["worst"].get<double>() < model.worst);
    CHECK(summary["layout"]["cut_length"].get<double>() <
          model.longest * std::sqrt(summary["mesh"]["area"].get<double>()));
  }
}

TEST_CASE("what has been cut enough is not cut again") {
  const Scratch scratch;
  mesh::SurfaceMesh bumpy = mesh::icosphere(3);
  for (Eigen::Index v = 0; v < bumpy.vertices.rows(); ++v)
    bumpy.vertices.row(v) *=
        1 + std::exp(-8 * (bumpy.vertices.row(v) - Eigen::RowVector3d(0, 0, 1)).squaredNorm());
  mesh::write_obj(scratch.path("bumpy.obj"), bumpy);
  CHECK(parameterize({scratch.path("bumpy.obj"), "-o", scratch.path("once"), "--no-picture", "-q"}).code ==
        0);
  CHECK(parameterize({scratch.path("once/bumpy_uv.obj"), "-o", scratch.path("twice"), "--no-picture", "-q"})
            .code == 0);
  const auto once = read_json(scratch.path("once/summary.json")),
             twice = read_json(scratch.path("twice/summary.json"));
  CHECK(once["layout"]["cut_edges"] == twice["layout"]["cut_edges"]);
  CHECK(once["energy"].get<double>() == doctest::Approx(twice["energy"].get<double>()).epsilon(1e-8));
}

TEST_CASE("cuts for a bound on the distortion are seams: no spurs of one to three edges") {
  const Scratch scratch;
  mesh::SurfaceMesh bumpy = mesh::icosphere(4);
  for (Eigen::Index v = 0; v < bumpy.vertices.rows(); ++v)
    bumpy.vertices.row(v) *=
        1 + 0.25 * std::sin(4 * bumpy.vertices(v, 0)) * std::cos(5 * bumpy.vertices(v, 1));
  mesh::write_obj(scratch.path("bumpy.obj"), bumpy);
  for (const char* bound : {"1.3", "1.4", "1.6"}) {
    CAPTURE(bound);
    const Outcome run = parameterize({scratch.path("bumpy.obj"), "-o", scratch.path("out"), "--no-picture",
                                      "-q", "--max-distortion", bound, "--overlap", "allow"});
    CHECK_MESSAGE(run.code == 0, run.err);
    const auto summary = read_json(scratch.path("out/summary.json"));
    CHECK(summary["distortion"]["worst"].get<double>() <= std::stod(bound));
    int spurs = 0, all = 0;
    for (const auto& [edges, count] : branches(mesh::read_obj(scratch.path("out/bumpy_uv.obj")))) {
      all += count;
      if (edges < 4) spurs += count;
    }
    CHECK(all > 3);
    CHECK(spurs == 0);
  }
}

TEST_CASE("--max-distortion cuts a part off where the way around it is shorter than the one to it") {
  // A ball in the middle of a plate, on a short thin stem.
  constexpr int segments = 24;
  std::vector<std::array<double, 2>> profile;
  for (const double radius : {6.0, 5.0, 4.0, 3.0, 2.0, 1.0, 0.5, 0.25}) profile.push_back({radius, 0});
  for (int i = 0; i < 16; ++i) {
    const double angle = 0.15 + (M_PI - 0.15) * i / 16;
    profile.push_back({std::sin(angle), 1.1 - std::cos(angle)});
  }
  const int rings = static_cast<int>(profile.size());
  mesh::SurfaceMesh ball;
  ball.vertices.resize(rings * segments + 1, 3);
  ball.triangles.resize((2 * rings - 1) * segments, 3);
  int t = 0;
  for (int r = 0; r < rings; ++r)
    for (int s = 0; s < segments; ++s) {
      const auto [radius, height] = profile[static_cast<std::size_t>(r)];
      const double angle = 2 * M_PI * (s + 0.5 * r) / segments;
      ball.vertices.row(r * segments + s) << radius * std::cos(angle), radius * std::sin(angle), height;
      const int a = r * segments + s, b = r * segments + (s + 1) % segments, top = rings * segments;
      ball.triangles.row(t++) << a, b, r + 1 == rings ? top : a + segments;
      if (r + 1 < rings) ball.triangles.row(t++) << b, b + segments, a + segments;
    }
  ball.vertices.row(rings * segments) << 0, 0, 2.1;
  const Scratch scratch;
  mesh::write_obj(scratch.path("ball.obj"), ball);
  const Outcome run = parameterize({scratch.path("ball.obj"), "-o", scratch.path("out"), "--no-picture", "-q",
                                    "--max-distortion", "2.5", "--overlap", "allow"});
  CHECK_MESSAGE(run.code == 0, run.err);
  const auto summary = read_json(scratch.path("out/summary.json"));
  CHECK(summary["distortion"]["worst"].get<double>() <= 2.5);
  CHECK(summary["layout"]["charts"] == 2);
  // One chart takes 15.6.
  CHECK_MESSAGE(summary["layout"]["cut_length"].get<double>() < 12, summary["layout"].dump());
}

TEST_CASE("overlap: charts with pinned or aligned vertices are not taken apart") {
  const Scratch scratch;
  const std::string model = scratch.path("face.obj"), out = scratch.path("out");
  mesh::write_obj(model, mesh::procedural_face(6));
  for (const std::vector<std::string>& places :
       {std::vector<std::string>{"--pin", "0:0,0"}, {"--soft-pin", "0:0,0"}, {"--horizontal", "0,5"}}) {
    std::vector<std::string> arguments{model, "--out", out, "--no-picture", "--overlap", "split"};
    arguments.insert(arguments.end(), places.begin(), places.end());
    const Outcome outcome = parameterize(arguments);
    CHECK(outcome.code == 2);
    CHECK_MESSAGE(outcome.err.find("pinned or aligned") != std::string::npos, outcome.err);
  }
  const Outcome aligned = parameterize({model, "--out", out, "--no-picture", "--horizontal", "0,5"});
  CHECK_MESSAGE(aligned.code == 0, aligned.err);
}
