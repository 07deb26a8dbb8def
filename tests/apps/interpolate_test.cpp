// The main job of isostretch-interpolate: frames from one pose to another.
#include "interpolate_app.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

using namespace isostretch;
using namespace isostretch::test;
using doctest::Approx;

namespace {

constexpr int frames = 6;
const double pi = std::acos(-1.0);

// Runs it from one mesh to the other, which must end well, and returns summary.json.
nlohmann::json solved(const Scratch& scratch, const mesh::TetMesh& first, const mesh::TetMesh& second,
                      std::vector<std::string> more = {}, const std::string& out = "out",
                      int count = frames) {
  mesh::write_tets(scratch.path("first.mesh"), first);
  mesh::write_tets(scratch.path("second.vtu"), second);
  std::vector<std::string> arguments{scratch.path("first.mesh"),
                                     scratch.path("second.vtu"),
                                     "-o",
                                     scratch.path(out),
                                     "--frames",
                                     std::to_string(count),
                                     "--no-picture"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome run = interpolate(arguments);
  REQUIRE_MESSAGE(run.code == 0, run.err);
  return read_json(scratch.path(out + "/summary.json"));
}

std::string frame_file(int number, const std::string& out) {
  char name[64];
  std::snprintf(name, sizeof name, "/frame_%04d.vtu", number);
  return out + name;
}

mesh::Points3 frame(const Scratch& scratch, int number, const std::string& out = "out") {
  return mesh::read_vtu_tets(scratch.path(frame_file(number, out))).vertices;
}

double furthest(const mesh::Points3& a, const mesh::Points3& b) {
  return (a - b).rowwise().norm().maxCoeff();
}

// Distances between the vertices do not notice rigid motions.
double difference_of_shapes(const mesh::Points3& a, const mesh::Points3& b) {
  double most = 0;
  for (Eigen::Index v = 0; v < a.rows(); ++v)
    for (Eigen::Index w = 0; w < v; w += 7)
      most = std::max(most, std::abs((a.row(v) - a.row(w)).norm() - (b.row(v) - b.row(w)).norm()));
  return most;
}

}  // namespace

TEST_CASE("interpolate: a bar that is twisted and bent: no inversions, one energy grows, the other falls") {
  const Scratch scratch;
  const mesh::TetMesh first = straight_bar(), second = twisted_and_bent(first, 0.5 * pi, 0.75 * pi);
  const auto summary = solved(scratch, first, second);
  CHECK(frame(scratch, 0) == first.vertices);
  CHECK(frame(scratch, frames) == second.vertices);
  CHECK(mesh::read_vtu_tets(scratch.path("out/frame_0003.vtu")).tets == first.tets);

  CHECK(summary["outcome"] == "finished");
  CHECK(summary["converged"] == true);
  CHECK(summary["warnings"].empty());
  CHECK(summary["min_det_F"].get<double>() > 0.2);
  const auto& all = summary["frames"];
  REQUIRE(all.size() == frames + 1);
  int iterations = 0;
  for (std::size_t i = 0; i <= frames; ++i) {
    CHECK(all[i]["time"].get<double>() == Approx(static_cast<double>(i) / frames));
    CHECK(all[i]["converged"] == true);
    CHECK(all[i]["min_det_F_1"].get<double>() > 0);
    CHECK(all[i]["min_det_F_2"].get<double>() > 0);
    CHECK(all[i]["inverted"] == 0);
    iterations += all[i]["iterations"].get<int>();
    if (i == 0) continue;
    CHECK(all[i]["psi_1"].get<double>() > all[i - 1]["psi_1"].get<double>());
    CHECK(all[i]["psi_2"].get<double>() < all[i - 1]["psi_2"].get<double>());
    CHECK(all[i]["change"].get<double>() < 0.1);
  }
  CHECK(std::abs(all[0]["psi_1"].get<double>()) < 1e-20);
  CHECK(std::abs(all[frames]["psi_2"].get<double>()) < 1e-20);
  CHECK(all[0]["psi_2"].get<double>() > 0.01);
  CHECK(summary["iterations"] == iterations);
  const std::string trace = read_file(scratch.path("out/trace.csv"));
  CHECK(std::count(trace.begin(), trace.end(), '\n') == 1 + (frames - 1) + iterations);
}

TEST_CASE("interpolate: exchanging the poses turns the frames around") {
  const Scratch scratch;
  const mesh::TetMesh a = straight_bar(), b = moved(twisted_and_bent(a, 0.5 * pi, 0.75 * pi), 1.1);
  const std::vector<std::string> exact{"--gradient-tolerance", "1e-9"};
  solved(scratch, a, b, exact, "there");
  solved(scratch, b, a, exact, "back");
  for (int i = 0; i <= frames; ++i)
    CHECK(furthest(frame(scratch, i, "there"), frame(scratch, frames - i, "back")) < 1e-6);
}

TEST_CASE("interpolate: a rigid motion of a pose changes the placement only") {
  const Scratch scratch;
  const mesh::TetMesh a = straight_bar(), b = twisted_and_bent(a, 0.5 * pi, 0.5 * pi);
  const std::vector<std::string> exact{"--gradient-tolerance", "1e-9"};
  const auto still = solved(scratch, a, b, exact, "still");
  const auto far = solved(scratch, a, moved(b, 2.5), exact, "far");
  for (int i = 0; i <= frames; ++i) {
    CHECK(difference_of_shapes(frame(scratch, i, "still"), frame(scratch, i, "far")) < 1e-6);
    const auto at = static_cast<std::size_t>(i);
    CHECK(far["frames"][at]["psi_1"].get<double>() ==
          Approx(still["frames"][at]["psi_1"].get<double>()).epsilon(1e-6));
  }
}

TEST_CASE("interpolate: a body that only moves stays as it is, evenly turned on its way") {
  const Scratch scratch;
  const mesh::TetMesh a = straight_bar(), b = moved(a, 2.0);
  const auto summary = solved(scratch, a, b);
  const Eigen::RowVector3d from = a.vertices.colwise().mean(), to = b.vertices.colwise().mean();
  for (std::size_t i = 0; i <= frames; ++i) {
    CHECK(std::abs(summary["frames"][i]["energy"].get<double>()) < 1e-20);
    const mesh::Points3 here = frame(scratch, static_cast<int>(i));
    CHECK(difference_of_shapes(here, a.vertices) < 1e-12);
    const double t = static_cast<double>(i) / frames;
    CHECK((here.colwise().mean() - ((1 - t) * from + t * to)).norm() < 1e-12);
    const mesh::Points3 turned = moved(a, 2.0 * t).vertices;
    CHECK(furthest(here.rowwise() - here.colwise().mean(), turned.rowwise() - turned.colwise().mean()) <
          1e-12);
  }
}

TEST_CASE("interpolate: identical poses cost nothing and do not move") {
  const Scratch scratch;
  const mesh::TetMesh bar = twisted_and_bent(straight_bar(), 1, 1);
  const auto summary = solved(scratch, bar, bar);
  CHECK(summary["iterations"] == 0);
  CHECK(std::abs(summary["frames"][3]["energy"].get<double>()) < 1e-20);
  for (int i = 1; i < frames; ++i) CHECK(furthest(frame(scratch, i), bar.vertices) < 1e-13);
}

TEST_CASE("interpolate: components move each for themselves, nodes of no element on a line") {
  const Scratch scratch;
  const mesh::TetMesh one = straight_bar(4);
  mesh::TetMesh a = one, b = one;
  const Eigen::Index n = one.vertices.rows(), m = one.tets.rows();
  const auto joined = [&](const mesh::Points3& second, const Eigen::RowVector3d& loose) {
    mesh::TetMesh both;
    both.vertices.resize(2 * n + 1, 3);
    both.vertices << one.vertices, second, loose;
    both.tets.resize(2 * m, 4);
    both.tets << one.tets, one.tets.array() + static_cast<int>(n);
    return both;
  };
  a = joined(one.vertices.rowwise() + Eigen::RowVector3d(0, 3, 0), {9, 9, 9});
  b = joined(moved(one, 1.5).vertices, {9, 9, 10});
  const auto summary = solved(scratch, a, b);
  CHECK(std::abs(summary["frames"][2]["energy"].get<double>()) < 1e-20);
  const mesh::Points3 half = frame(scratch, frames / 2);
  CHECK(furthest(half.topRows(n), one.vertices) < 1e-12);
  CHECK(difference_of_shapes(half.middleRows(n, n), one.vertices) < 1e-12);
  CHECK((half.row(2 * n) - Eigen::RowVector3d(9, 9, 9.5)).norm() < 1e-14);
}

TEST_CASE("interpolate: a bar twisted by turns is untwisted without a jump") {
  const Scratch scratch;
  const auto summary =
      solved(scratch, straight_bar(24), twisted_and_bent(straight_bar(24), 3 * pi, 0), {}, "out", 12);
  CHECK(summary["warnings"].empty());
  for (int i = 1; i <= 12; ++i) {
    CHECK(furthest(frame(scratch, i - 1), frame(scratch, i)) < 0.5);
    CHECK(summary["frames"][static_cast<std::size_t>(i)]["change"].get<double>() < 0.05);
  }
}

TEST_CASE("interpolate: in the plane, with pictures") {
  const Scratch scratch;
  const mesh::SurfaceMesh sheet = mesh::grid(16, 4, 4, 1);
  mesh::SurfaceMesh arc = sheet;
  for (Eigen::Index v = 0; v < arc.vertices.rows(); ++v) {
    const double angle = 1.2 * sheet.vertices(v, 0), radius = 2 - sheet.vertices(v, 1);
    arc.vertices.row(v) << radius * std::sin(angle), -radius * std::cos(angle), 0;
  }
  mesh::write_obj(scratch.path("sheet.obj"), sheet);
  mesh::write_obj(scratch.path("arc.obj"), arc);
  for (const char* energy : {"symmetric_arap", "symmetric_dirichlet", "arap"}) {
    const std::string out = scratch.path(energy);
    const Outcome run = interpolate({scratch.path("sheet.obj"), scratch.path("arc.obj"), "-e", energy, "-o",
                                     out, "--frames", "5", "--format", "obj"});
    REQUIRE_MESSAGE(run.code == 0, run.err);
    const bool barrier = std::string(energy) != "arap";
    CHECK((run.err.find("no barrier") == std::string::npos) == barrier);
    const auto summary = read_json(out + "/summary.json");
    CHECK(summary["warnings"].size() == (barrier ? 0 : 1));
    CHECK(summary["min_det_F"].get<double>() > 0);
    CHECK(summary["mesh"]["element"] == "triangle");
    for (const char* picture : {"/interpolation.png", "/energy.png"})
      CHECK(read_file(out + picture).substr(1, 3) == "PNG");
    CHECK(mesh::read_obj(out + "/frame_0005.obj").vertices == arc.vertices);
    CHECK(mesh::read_obj(out + "/frame_0002.obj").vertices.col(2).isZero(0));
  }
}

TEST_CASE("interpolate: every start of the frames leads to the same ones, on any number of threads") {
  const Scratch scratch;
  const mesh::TetMesh a = straight_bar(), b = twisted_and_bent(a, 0.8 * pi, 0.5 * pi);
  solved(scratch, a, b, {"--initial-guess", "previous", "--gradient-tolerance", "1e-9"}, "simple", 12);
  const auto quick = solved(scratch, a, b, {"--gradient-tolerance", "1e-9", "--threads", "1"}, "quick", 12);
  solved(scratch, a, b, {"--gradient-tolerance", "1e-9", "--threads", "2"}, "two", 12);
  const auto usual = solved(scratch, a, b, {}, "usual", 12);
  const auto usual_simple = solved(scratch, a, b, {"--initial-guess", "previous"}, "usual_simple", 12);
  CHECK(usual["iterations"].get<int>() < usual_simple["iterations"].get<int>());
  CHECK(usual["factorizations"].get<int>() < quick["factorizations"].get<int>());
  for (int i = 0; i <= 12; ++i) {
    CHECK(furthest(frame(scratch, i, "simple"), frame(scratch, i, "quick")) < 1e-6);
    CHECK(furthest(frame(scratch, i, "usual"), frame(scratch, i, "quick")) < 4e-4);
    CHECK(read_file(scratch.path(frame_file(i, "quick"))) == read_file(scratch.path(frame_file(i, "two"))));
  }
}

TEST_CASE("interpolate: one frame is the second pose alone") {
  const Scratch scratch;
  const mesh::TetMesh a = straight_bar(), b = twisted_and_bent(a, 1, 1);
  const auto summary = solved(scratch, a, b, {"--format", "msh"}, "out", 1);
  CHECK(summary["frames"].size() == 2);
  CHECK(mesh::read_tets(scratch.path("out/frame_0001.msh")).vertices == b.vertices);
  CHECK(read_file(scratch.path("out/trace.csv")).rfind("iteration,", 0) == 0);
}

TEST_CASE("interpolate: Ctrl-C and limits end it, and what is done is written") {
  const Scratch scratch;
  const mesh::TetMesh a = mesh::tet_bar(24, 6, 6, 4, 1, 1);
  mesh::write_tets(scratch.path("a.msh"), a);
  mesh::write_tets(scratch.path("b.msh"), twisted_and_bent(a, pi, 1));
  const std::string out = scratch.path("out");
  const auto command = [&](const char* count) {
    return std::vector<std::string>{
        scratch.path("a.msh"), scratch.path("b.msh"), "-o", out, "--no-picture", "--frames", count};
  };
  SUBCASE("Ctrl-C") {
    const Outcome run = interpolate(command("500"), [&](int process) {
      for (int i = 0; i < 20000 && !std::filesystem::exists(out); ++i)
        std::this_thread::sleep_for(std::chrono::microseconds(500));
      std::this_thread::sleep_for(std::chrono::milliseconds(300));  // some frames
      ::kill(process, SIGINT);
    });
    CHECK_MESSAGE(run.code == 5, run.err);
    CHECK(run.err.find("interrupted") != std::string::npos);
    const auto summary = read_json(out + "/summary.json");
    CHECK(summary["outcome"] == "stopped");
    for (int i = 0; i <= summary["frames_made"].get<int>(); ++i)
      CHECK(std::filesystem::exists(scratch.path(frame_file(i, "out"))));
    CHECK(summary["frames_made"].get<int>() < 500);
    CHECK(summary["min_det_F"].get<double>() > 0);
  }
  SUBCASE("time") {
    std::vector<std::string> limited = command("500");
    limited.insert(limited.end(), {"--time-limit", "0.2"});
    const Outcome run = interpolate(limited);
    CHECK_MESSAGE(run.code == 5, run.err);
    CHECK(read_json(out + "/summary.json")["outcome"] == "stopped");
  }
  SUBCASE("iterations: every frame is kept as it is") {
    std::vector<std::string> limited = command("4");
    limited.insert(limited.end(), {"--max-iterations", "1", "--gradient-tolerance", "1e-12"});
    const Outcome run = interpolate(limited);
    CHECK_MESSAGE(run.code == 5, run.err);
    CHECK(run.err.find("did not converge") != std::string::npos);
    CHECK(read_json(out + "/summary.json")["frames"].size() == 5);
  }
}
