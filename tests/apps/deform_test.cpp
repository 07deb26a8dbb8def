// The main job of isostretch-deform: frames, handles, regions, elements, restart.
#include "conditional.hpp"
#include "deform_app.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <thread>

using namespace isostretch;
using namespace isostretch::test;
using doctest::Approx;
using Json = nlohmann::ordered_json;
using isostretch::tests::outside_data;
using isostretch::tests::outside_path;

namespace {

// Runs the scene, which must end well, and returns summary.json.
nlohmann::json solved(const Scratch& scratch, const Json& scene, std::vector<std::string> more = {},
                      const std::string& out = "out") {
  std::vector<std::string> arguments{write_scene(scratch, scene), "-o", scratch.path(out), "--no-picture"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome run = deform(arguments);
  REQUIRE_MESSAGE(run.code == 0, run.err);
  return read_json(scratch.path(out + "/summary.json"));
}

mesh::Points3 frame(const Scratch& scratch, int number, const std::string& out = "out") {
  char name[64];
  std::snprintf(name, sizeof name, "/frame_%04d.vtu", number);
  return mesh::read_vtu_tets(scratch.path(out + name)).vertices;
}

void check_same_frames(const Scratch& scratch, const std::string& a, const std::string& b, int last) {
  for (int i = 0; i <= last; ++i) {
    char name[64];
    std::snprintf(name, sizeof name, "/frame_%04d.vtu", i);
    CHECK_MESSAGE(read_file(scratch.path(a + name)) == read_file(scratch.path(b + name)), name);
  }
}

}  // namespace

TEST_CASE(
    "deform: a twisted bar: every frame a file, handles in place to the bit, all numbers in the summary") {
  const Scratch scratch;
  const Outcome run =
      deform({write_scene(scratch, twisted_bar(90, 3)), "--out", scratch.path("out"), "--threads", "2"});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  for (const char* file :
       {"frame_0000.vtu", "frame_0001.vtu", "frame_0002.vtu", "frame_0003.vtu", "summary.json", "trace.csv",
        "deform.png", "deform.pvd", "report.html", "restart.json"})
    CHECK_MESSAGE(std::filesystem::exists(scratch.path(std::string("out/") + file)), file);

  const mesh::TetMesh rest = mesh::tet_bar(8, 2, 2, 4, 1, 1);
  const mesh::TetMesh last = mesh::read_vtu_tets(scratch.path("out/frame_0003.vtu"));
  CHECK(last.tets == rest.tets);
  CHECK(frame(scratch, 0) == rest.vertices);
  for (Eigen::Index v = 0; v < rest.vertices.rows(); ++v) {
    const Eigen::RowVector3d p = rest.vertices.row(v);
    if (p.x() == 0) CHECK(last.vertices.row(v) == p);
    // Turned about the middle (4, 1/2, 1/2).
    if (p.x() == 4) CHECK((last.vertices.row(v) - Eigen::RowVector3d(4, 1 - p.z(), p.y())).norm() < 1e-14);
  }

  const auto summary = read_json(scratch.path("out/summary.json"));
  CHECK(summary["outcome"] == "finished");
  CHECK(summary["converged"] == true);
  CHECK(summary["frames"].size() == 4);
  CHECK(summary["threads"] == 2);
  int iterations = 0;
  for (int i = 1; i <= 3; ++i) {
    const auto& f = summary["frames"][static_cast<std::size_t>(i)];
    CHECK(f["frame"] == i);
    CHECK(f["time"].get<double>() == Approx(i / 3.0));
    CHECK(f["converged"] == true);
    CHECK(f["min_det_F"].get<double>() > 0.5);
    CHECK(f["inverted"] == 0);
    for (const char* key : {"energy", "gradient_inf_norm", "seconds", "factorizations"})
      CHECK_MESSAGE(f[key].is_number(), key);
    iterations += f["iterations"].get<int>();
  }
  CHECK(summary["iterations"] == iterations);
  const std::string trace = read_file(scratch.path("out/trace.csv"));
  CHECK(trace.rfind("iteration,", 0) == 0);
  CHECK(std::count(trace.begin(), trace.end(), '\n') == 1 + 3 + iterations);
  CHECK(read_file(scratch.path("out/deform.png")).substr(1, 3) == "PNG");
  const std::string vtu = read_file(scratch.path("out/frame_0003.vtu"));
  for (const char* field : {"min_det_F", "stress_norm", "length_change", "displacement"})
    CHECK_MESSAGE(vtu.find(field) != std::string::npos, field);
}

TEST_CASE("deform: a run that stops and goes on writes the same bytes as one that does not") {
  const Scratch scratch;
  const Json scene = twisted_bar(120, 6);
  solved(scratch, scene, {}, "whole");
  const std::string file = write_scene(scratch, scene), out = scratch.path("parts");
  const Outcome first = deform({file, "-o", out, "--no-picture", "--stop-after", "3"});
  CHECK(first.code == 5);
  CHECK(first.err.find("--stop-after") != std::string::npos);
  CHECK(!std::filesystem::exists(out + "/frame_0004.vtu"));
  CHECK(read_json(out + "/summary.json")["outcome"] == "stopped_by_stop_after");
  CHECK(read_json(out + "/summary.json")["frames_made"] == 3);
  CHECK(deform({file, "-o", out, "--no-picture", "--stop-after", "1", "--restart", "--threads", "1"}).code ==
        5);
  CHECK(std::filesystem::exists(out + "/frame_0004.vtu"));
  const Outcome second = deform({file, "-o", out, "--no-picture", "--restart"});
  CHECK_MESSAGE(second.code == 0, second.err);
  check_same_frames(scratch, "whole", "parts", 6);
  const auto a = read_json(scratch.path("whole/summary.json")), b = read_json(out + "/summary.json");
  CHECK(b["restarted_at"] == 5);
  for (std::size_t i = 1; i <= 6; ++i) CHECK(a["frames"][i]["energy"] == b["frames"][i]["energy"]);
  SUBCASE("a run that is finished has nothing left to do") {
    CHECK(deform({file, "-o", out, "--no-picture", "--restart"}).code == 0);
    check_same_frames(scratch, "whole", "parts", 6);
  }
  SUBCASE("another scene is refused, and the key named") {
    const Outcome other = deform({write_scene(scratch, twisted_bar(121, 6)), "-o", out, "--restart"});
    CHECK(other.code == 3);
    CHECK(other.err.find("'handles' has changed") != std::string::npos);
    write_scene(scratch, scene);
    const Outcome solver = deform({file, "-o", out, "--restart", "--projection", "clamp"});
    CHECK(solver.err.find("'newton' has changed") != std::string::npos);
  }
  SUBCASE("a state that is damaged is refused") {
    scratch.write("parts/restart.json", "{\"scene\": {}, ");
    CHECK(deform({file, "-o", out, "--restart"}).code == 3);
  }
}

TEST_CASE("deform: Ctrl-C ends after the iteration, and --restart goes on to the same bytes") {
  const Scratch scratch;
  Json scene = twisted_bar(200, 8);
  scene["mesh"]["bar"]["cells"] = {24, 6, 6};
  const std::string file = write_scene(scratch, scene), out = scratch.path("parts");
  const Outcome first = deform({file, "-o", out, "--no-picture"}, [&](int process) {
    for (int i = 0; i < 20000 && !std::filesystem::exists(out + "/frame_0002.vtu"); ++i)
      std::this_thread::sleep_for(std::chrono::microseconds(500));
    ::kill(process, SIGINT);
  });
  CHECK_MESSAGE(first.code == 5, first.err);
  CHECK(first.err.find("interrupted") != std::string::npos);
  CHECK(read_json(out + "/summary.json")["outcome"] == "stopped");
  CHECK(deform({file, "-o", out, "--no-picture", "--restart"}).code == 0);
  solved(scratch, scene, {}, "whole");
  check_same_frames(scratch, "whole", "parts", 8);
}

TEST_CASE("deform: all from the command line, tets and surfaces of a file") {
  const Scratch scratch;
  mesh::write_tets(scratch.path("bar.msh"), mesh::tet_bar(6, 2, 2, 3, 1, 1));
  for (const char* energy : {"arap", "symmetric_arap", "stable_neo_hookean"}) {
    const Outcome run = deform({scratch.path("bar.msh"), "--energy", energy, "--handle", "slab:x,min,0.01",
                                "--handle", "slab:x,max,0.01;name=end;rotate=0,1,0:40;translate=0,0,0.3",
                                "--frames", "2", "-o", scratch.path(energy), "--no-picture"});
    CHECK_MESSAGE(run.code == 0, run.err);
    CHECK(read_json(scratch.path(std::string(energy) + "/summary.json"))["regions"][0]["energy_name"] ==
          energy);
  }
  mesh::write_obj(scratch.path("sheet.obj"), mesh::grid(8, 2, 4, 1));
  const Outcome flat = deform({scratch.path("sheet.obj"), "--handle", "slab:x,min,0.01", "--handle",
                               "slab:x,max,0.01;rotate=90", "--frames", "3", "-e", "symmetric_dirichlet",
                               "--format", "obj", "-o", scratch.path("flat")});
  CHECK_MESSAGE(flat.code == 0, flat.err);
  const mesh::SurfaceMesh turned = mesh::read_obj(scratch.path("flat/frame_0003.obj"));
  CHECK(turned.vertices.col(2).isZero(0));
  CHECK((turned.vertices.row(8) - Eigen::RowVector3d(4.5, 0.5, 0)).norm() < 1e-14);
}

TEST_CASE("deform: --param and material set the energy's parameters") {
  const Scratch scratch;
  mesh::write_tets(scratch.path("bar.msh"), mesh::tet_bar(2, 1, 1));
  const auto parameters = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{
        scratch.path("bar.msh"), "--handle", "slab:x,min,0.1", "-o", scratch.path("out"), "--frames", "1",
        "--no-picture"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = deform(arguments);
    REQUIRE_MESSAGE(run.code == 0, run.err);
    return read_json(scratch.path("out/summary.json"))["regions"][0]["energy_parameters"];
  };
  CHECK(parameters({"-e", "stable_neo_hookean", "-p", "mu=2,lambda=7"})["lambda"] == 7.0);
  // E = 2.5, nu = 0.25: mu = lambda = 1.
  const std::vector<std::string> rubber{"--young", "2.5", "--poisson", "0.25"};
  const auto of = [&](const std::string& energy) {
    std::vector<std::string> more{"-e", energy};
    more.insert(more.end(), rubber.begin(), rubber.end());
    return parameters(more);
  };
  CHECK(of("neo_hookean_log")["lambda"].get<double>() == Approx(1));
  CHECK(of("corotational")["kappa"].get<double>() == Approx(1));
  CHECK(of("stable_neo_hookean")["lambda"].get<double>() == Approx(2));
  CHECK(of("stable_neo_hookean_log")["mu"].get<double>() == Approx(4.0 / 3));
  CHECK(of("stable_neo_hookean_log")["lambda"].get<double>() == Approx(1 + 5.0 / 6));
}

TEST_CASE("deform: materials given by Lame parameters agree at small strain, in 2D and 3D") {
  // A bar stretched by a ten-thousandth: energies of all materials are those of linear elasticity.
  const Scratch scratch;
  for (const bool flat : {false, true}) {
    double expected = 0;
    for (const char* energy : {"fixed_corotational", "corotational", "hencky", "neo_hookean_log",
                               "st_venant_kirchhoff", "stable_neo_hookean", "stable_neo_hookean_log"}) {
      Json scene = twisted_bar(0, 1);
      scene["mesh"]["bar"] =
          flat ? Json{{"cells", {4, 2}}, {"size", {2, 1}}} : Json{{"cells", {4, 2, 2}}, {"size", {2, 1, 1}}};
      scene["energy"] = energy;
      scene["material"] = {{"mu", 3}, {"lambda", 5}};
      scene["handles"][1].erase("rotate");
      scene["handles"][1]["translate"] = flat ? Json{2e-4, 0} : Json{2e-4, 0, 0};
      const auto summary = solved(scratch, scene, {"--gradient-tolerance", "1e-9"});
      // The slope of psi at rest is zero, but stable_neo_hookean_log has a constant: a difference of
      // energies.
      Json still = scene;
      still["handles"][1]["translate"] = flat ? Json{0, 0} : Json{0, 0, 0};
      const double energy_at_rest =
          solved(scratch, still, {"--gradient-tolerance", "1e-9"})["frames"][1]["energy"];
      const double gained = summary["frames"][1]["energy"].get<double>() - energy_at_rest;
      if (expected == 0) expected = gained;
      CAPTURE(energy);
      CHECK(gained == Approx(expected).epsilon(2e-3));
    }
  }
}

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

TEST_CASE("deform: regions have energies and materials of their own") {
  const Scratch scratch;
  Json scene = twisted_bar(0, 1);
  scene["energy"] = "neo_hookean_log";
  scene["material"] = {{"young", 1}, {"poisson", 0.3}};
  scene["regions"] = {{{"name", "stiff"},
                       {"select", {{"slab", {{"axis", "x"}, {"end", "min"}, {"fraction", 0.5}}}}},
                       {"material", {{"young", 100}, {"poisson", 0.3}}}},
                      {{"elements", {190, 191}}, {"energy", "symmetric_dirichlet"}}};
  scene["handles"][1].erase("rotate");
  scene["handles"][1]["translate"] = {0.5, 0, 0};
  const auto summary = solved(scratch, scene);
  CHECK(summary["regions"].size() == 3);
  CHECK(summary["regions"][0]["elements"] == 96);
  CHECK(summary["regions"][1]["elements"] == 2);
  CHECK(summary["regions"][2]["name"] == "rest");
  const mesh::Points3 rest = frame(scratch, 0), last = frame(scratch, 1);
  for (Eigen::Index v = 0; v < rest.rows(); ++v)
    if (rest(v, 0) == 2) CHECK(last(v, 0) - 2 < 0.05);  // nearly all is left to the soft half
  CHECK(read_file(scratch.path("out/frame_0001.vtu")).find("\"region\"") != std::string::npos);
}

TEST_CASE("deform: every kind of element, with the quadrature asked for") {
  const Scratch scratch;
  const auto run = [&](const char* element, int dim, Json more = Json::object()) {
    Json scene = twisted_bar(0, 1);
    scene["mesh"]["bar"] = {{"cells", dim == 2 ? Json{6, 2} : Json{4, 1, 1}},
                            {"size", dim == 2 ? Json{3, 1} : Json{4, 1, 1}},
                            {"element", element}};
    scene["handles"][1]["rotate"] =
        dim == 2 ? Json{{"degrees", 30}} : Json{{"axis", {0, 0, 1}}, {"degrees", 30}};
    scene.update(more);
    return solved(scratch, scene, {"--format", dim == 2 ? "obj" : "vtu"});
  };
  CHECK(run("tet", 3)["mesh"]["points_per_element"] == 1);
  CHECK(run("hex", 3)["mesh"]["points_per_element"] == 8);
  CHECK(run("quadratic_tet", 3)["mesh"]["points_per_element"] == 4);
  CHECK(run("tet", 3, {{"order", 2}, {"quadrature", 3}})["mesh"]["points_per_element"] == 8);
  CHECK(run("triangle", 2)["mesh"]["element"] == "triangle");
  CHECK(run("quad", 2)["mesh"]["points_per_element"] == 4);
  CHECK(run("triangle", 2, {{"order", 2}})["mesh"]["element"] == "quadratic triangle");
}

TEST_CASE("deform: frames as MSH and OBJ") {
  const Scratch scratch;
  solved(scratch, twisted_bar(30, 1), {"--format", "msh"}, "msh");
  solved(scratch, twisted_bar(30, 1), {}, "vtu");
  solved(scratch, twisted_bar(30, 1), {"--format", "obj"}, "obj");
  CHECK(mesh::read_tets(scratch.path("msh/frame_0001.msh")).vertices == frame(scratch, 1, "vtu"));
  CHECK(mesh::read_obj(scratch.path("obj/frame_0001.obj")).triangles.rows() == 2 * (2 * 4 + 4 * 16));
  CHECK(!std::filesystem::exists(scratch.path("obj/deform.pvd")));
}

TEST_CASE("deform: one thread and two write the same bytes") {
  const Scratch scratch;
  solved(scratch, twisted_bar(60, 2), {"--threads", "1"}, "one");
  solved(scratch, twisted_bar(60, 2), {"--threads", "2"}, "two");
  check_same_frames(scratch, "one", "two", 2);
}

TEST_CASE("deform: models of others" * outside_data({"meshes/tets/octopus-low.mesh"})) {
  const Scratch scratch;
  for (const char* energy : {"arap", "symmetric_dirichlet"}) {
    const Outcome run = deform({outside_path("meshes/tets/octopus-low.mesh"), "-e", energy, "--handle",
                                "slab:y,max,0.15", "--handle", "nearest:0.53,-0.08,0.08;translate=0,0.2,0",
                                "--frames", "2", "-o", scratch.path(energy)});
    CHECK_MESSAGE(run.code == 0, run.err);
  }
}
