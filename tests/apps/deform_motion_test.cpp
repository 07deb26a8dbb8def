// How handles of isostretch-deform move a body: guesses, keyframes, soft handles.
#include "deform_app.hpp"
#include "deform_results.hpp"

#include <isostretch/mesh/types.hpp>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <Eigen/Core>

using namespace isostretch;
using namespace isostretch::test;
using doctest::Approx;
using Json = nlohmann::ordered_json;

TEST_CASE("deform: a translation of all handles moves everything alike, from every guess") {
  const Scratch scratch;
  for (const char* guess : {"rest", "previous", "harmonic", "biharmonic"}) {
    Json scene = twisted_bar(0, 2);
    scene["initial_guess"] = guess;
    scene["mesh"]["bar"]["cells"] = {4, 1, 1};
    for (Json& handle : scene["handles"]) {
      handle.erase("rotate");
      handle["translate"] = {0.2, -0.1, 0.3};
    }
    const auto summary = solved(scratch, scene);
    CHECK(summary["frames"][2]["min_det_F"].get<double>() == Approx(1).epsilon(1e-6));
    const mesh::Points3 moved = frame(scratch, 2) - frame(scratch, 0);
    CHECK((moved.rowwise() - Eigen::RowVector3d(0.2, -0.1, 0.3)).cwiseAbs().maxCoeff() < 1e-6);
  }
}

TEST_CASE("deform: where the guess inverts an element under a barrier, the handles go in parts") {
  const Scratch scratch;
  Json scene = twisted_bar(0, 1);
  scene["initial_guess"] = "previous";  // only the handle moves, by two elements' lengths into the bar
  scene["handles"][1].erase("rotate");
  scene["handles"][1]["translate"] = {-1.0, 0, 0};
  const auto summary = solved(scratch, scene);
  CHECK(summary["frames"][1]["parts"].get<int>() > 1);
  CHECK(summary["frames"][1]["min_det_F"].get<double>() > 0);
  const mesh::Points3 rest = frame(scratch, 0), last = frame(scratch, 1);
  for (Eigen::Index v = 0; v < rest.rows(); ++v)
    if (rest(v, 0) == 4) CHECK(last(v, 0) == 3);
  const double from_harmonic = [&] {
    scene["initial_guess"] = "harmonic";
    return solved(scratch, scene)["frames"][1]["energy"].get<double>();
  }();
  CHECK(summary["frames"][1]["energy"].get<double>() == Approx(from_harmonic).epsilon(1e-5));
}

TEST_CASE("deform: frame 1 takes handles from rest to a first keyframe elsewhere") {
  const Scratch scratch;
  Json scene = twisted_bar(0, 2);
  scene["mesh"]["bar"]["cells"] = {4, 2, 2};
  scene["handles"][1].erase("rotate");
  scene["handles"][1]["keyframes"] = {{{"time", 0}, {"translate", {-2, 0, 0}}},
                                      {{"time", 1}, {"translate", {-2.1, 0, 0}}}};
  for (const char* guess : {"biharmonic", "previous"}) {
    scene["initial_guess"] = guess;
    const auto summary = solved(scratch, scene);
    CHECK(summary["frames"][1]["time"] == 0.5);
    CHECK(summary["frames"][2]["min_det_F"].get<double>() > 0);
    const mesh::Points3 rest = frame(scratch, 0), first = frame(scratch, 1);
    for (Eigen::Index v = 0; v < rest.rows(); ++v)
      if (rest(v, 0) == 4) CHECK(first(v, 0) == Approx(1.95));
  }
}

TEST_CASE("deform: a first keyframe that is turned is reached by turning") {
  const Scratch scratch;
  Json scene = twisted_bar(0, 1);
  scene["mesh"]["bar"]["size"] = {12, 1, 1};
  scene["handles"][1]["keyframes"] = {{{"time", 3}, {"rotate", scene["handles"][1]["rotate"]}},
                                      {{"time", 4}, {"rotate", scene["handles"][1]["rotate"]}}};
  for (Json& key : scene["handles"][1]["keyframes"]) key["rotate"]["degrees"] = 180;
  scene["handles"][1].erase("rotate");
  const auto summary = solved(scratch, scene);
  CHECK(summary["frames"][1]["min_det_F"].get<double>() > 0);
}

TEST_CASE("deform: the guess is spread on thin bodies and fine sheets") {
  const Scratch scratch;
  const auto warnings = [&](const Json& bar) {
    Json scene = twisted_bar(0, 1);
    scene["mesh"]["bar"] = bar;
    const bool flat = bar["cells"].size() == 2;
    scene["handles"][1].erase("rotate");
    scene["handles"][1]["translate"] = flat ? Json{0.1, 0} : Json{0.1, 0, 0};
    return solved(scratch, scene, {"--format", flat ? "obj" : "vtu", "--max-iterations", "50"})["warnings"];
  };
  CHECK(warnings({{"cells", {60, 60}}, {"size", {1, 1}}}).empty());
  CHECK(warnings({{"cells", {30, 20, 7}}, {"size", {4, 1, 0.1}}}).empty());
}

TEST_CASE("deform: the guess needs more quadrature points than the scene asks for") {
  const Scratch scratch;
  for (const Json& element : {Json("hex"), Json("quadratic_tet"), Json("quad"), Json("quadratic_triangle")}) {
    const bool flat = element == "quad" || element == "quadratic_triangle";
    Json scene = twisted_bar(0, 1);
    scene["mesh"]["bar"] = {{"cells", flat ? Json{4, 2} : Json{4, 2, 2}}, {"element", element}};
    scene["quadrature"] = 1;
    scene["handles"][1].erase("rotate");
    scene["handles"][1]["translate"] = flat ? Json{0.1, 0} : Json{0.1, 0, 0};
    const Outcome run = deform({write_scene(scratch, scene), "-o", scratch.path("out"), "--no-picture"});
    CAPTURE(element);
    CAPTURE(run.err);
    CHECK(run.code != 1);
    CHECK(read_json(scratch.path("out/summary.json"))["warnings"].empty());
  }
}

TEST_CASE("deform: keyframes, more than a full turn and back") {
  const Scratch scratch;
  Json scene = twisted_bar(0, 6);
  scene["energy"] = "arap";
  scene["mesh"]["bar"]["size"] = {12, 1, 1};
  scene["handles"][1].erase("rotate");
  scene["handles"][1]["keyframes"] = {
      {{"time", 2}},
      {{"time", 3}, {"rotate", {{"axis", {1, 0, 0}}, {"degrees", 180}}}, {"translate", {0.5, 0, 0}}},
      {{"time", 5}}};
  const auto summary = solved(scratch, scene);
  CHECK(summary["frames"][0]["time"] == 2.0);
  CHECK(summary["frames"][2]["time"] == 3.0);
  CHECK(summary["frames"][6]["time"] == 5.0);
  const mesh::Points3 rest = frame(scratch, 0), turned = frame(scratch, 2), back = frame(scratch, 6);
  for (Eigen::Index v = 0; v < rest.rows(); ++v)
    if (rest(v, 0) == 12)
      CHECK((turned.row(v) - Eigen::RowVector3d(12.5, 1 - rest(v, 1), 1 - rest(v, 2))).norm() < 1e-14);
  CHECK((back - rest).cwiseAbs().maxCoeff() < 1e-4);
}

TEST_CASE("deform: a soft handle pulls, the harder the heavier, and in any units alike") {
  const Scratch scratch;
  const auto reached = [&](double weight, double unit) {
    Json scene = twisted_bar(0, 1);
    scene["mesh"]["bar"]["size"] = {4 * unit, unit, unit};
    scene["handles"][1].erase("rotate");
    scene["handles"][1]["translate"] = {unit, 0, 0};
    scene["handles"][1]["soft"] = weight;
    solved(scratch, scene);
    const mesh::Points3 rest = frame(scratch, 0), last = frame(scratch, 1);
    double mean = 0;
    int count = 0;
    for (Eigen::Index v = 0; v < rest.rows(); ++v)
      if (rest(v, 0) == 4 * unit) mean += (last(v, 0) - rest(v, 0)) / unit, ++count;
    return mean / count;
  };
  const double light = reached(0.3, 1), heavy = reached(1e5, 1);
  CHECK(light > 0.02);
  CHECK(light < 0.8);
  CHECK(heavy == Approx(1).epsilon(1e-3));
  CHECK(reached(0.3, 1e-3) == Approx(light).epsilon(1e-5));
}
