// The main job of isostretch-deform: frames, materials, regions, elements, formats.
#include "conditional.hpp"
#include "deform_app.hpp"
#include "deform_results.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::test;
using doctest::Approx;
using Json = nlohmann::ordered_json;
using isostretch::tests::outside_data;
using isostretch::tests::outside_path;

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

TEST_CASE("deform: models of others" * outside_data({"meshes/tets/octopus-low.mesh"})) {
  const Scratch scratch;
  for (const char* energy : {"arap", "symmetric_dirichlet"}) {
    const Outcome run = deform({outside_path("meshes/tets/octopus-low.mesh"), "-e", energy, "--handle",
                                "slab:y,max,0.15", "--handle", "nearest:0.53,-0.08,0.08;translate=0,0.2,0",
                                "--frames", "2", "-o", scratch.path(energy)});
    CHECK_MESSAGE(run.code == 0, run.err);
  }
}
