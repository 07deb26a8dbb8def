// One schema of scenes for all apps, older scenes and flags, and --set.
#include "deform_app.hpp"
#include "failure.hpp"
#include "interpolate_app.hpp"
#include "manipulate_app.hpp"
#include "process.hpp"
#include "scratch.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

using namespace isostretch;
using namespace isostretch::test;
using Json = nlohmann::ordered_json;

namespace {

bool says(const Outcome& outcome, const std::string& text) {
  return outcome.err.find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("scenes: one file serves two apps, and each names the keys that it has no use for") {
  const Scratch scratch;
  Json scene = twisted_bar(30, 2);
  scene["schema"] = 1;
  scene["manipulation"] = {{"alpha", 100}};
  scene["initial_guess"] = "harmonic";
  const std::string file = write_scene(scratch, scene);
  const Outcome deformed = deform({file, "-o", scratch.path("deformed"), "--no-picture"});
  CHECK(deformed.code == 0);
  CHECK(says(deformed, "'manipulation' is of no use to this app"));
  CHECK_FALSE(says(deformed, "'initial_guess' is"));
  const Outcome manipulated = manipulate({file, "-o", scratch.path("manipulated"), "--no-picture"});
  CHECK(manipulated.code == 0);
  CHECK(says(manipulated, "'initial_guess' is of no use to this app"));
  CHECK(says(manipulated, "'energy' is of no use to this app"));
}

TEST_CASE("scenes: an older scene gives the same as what the notice says it is now") {
  const Scratch scratch;
  Json old = swirl(90);
  old["units"] = "mesh";
  old["gap"] = 1e-5;
  old["blend"] = "quaternion";
  const Outcome before = manipulate({write_scene(scratch, old), "-o", scratch.path("old"), "--no-picture"});
  CHECK(before.code == 0);
  CHECK(says(before, "'units' is now 'manipulation.length_unit'"));
  CHECK(says(before, "'gap' is now 'manipulation.gap_tolerance'"));
  Json now = swirl(90);
  now["schema"] = 1;
  now["manipulation"] = {{"length_unit", "mesh"}, {"gap_tolerance", 1e-5}, {"blend", "quaternion"}};
  const Outcome after = manipulate({write_scene(scratch, now), "-o", scratch.path("now"), "--no-picture"});
  CHECK(after.code == 0);
  CHECK_FALSE(says(after, "is now"));
  CHECK(read_file(scratch.path("old/frame_0001.vtu")) == read_file(scratch.path("now/frame_0001.vtu")));
}

TEST_CASE("scenes: an older scene that is wrong is refused by the key that it has") {
  const Scratch scratch;
  Json old = swirl(90);
  old["alpha"] = 0;
  const Outcome run = manipulate({write_scene(scratch, old), "-o", scratch.path("out")});
  CHECK(run.code == 3);
  CHECK(says(run, "scene.json: alpha: must be a number > 0, not 0"));
  CHECK_FALSE(std::filesystem::exists(scratch.path("out")));
}

TEST_CASE("scenes: a version that there is not, and older keys under the present one, are refused") {
  const Scratch scratch;
  Json scene = swirl(90);
  scene["schema"] = 2;
  Outcome run = manipulate({write_scene(scratch, scene), "-o", scratch.path("out")});
  CHECK(run.code == 3);
  CHECK(says(run, "scene.json: schema: must be 1"));
  scene["schema"] = 1;
  scene["units"] = "mesh";
  run = manipulate({write_scene(scratch, scene), "-o", scratch.path("out")});
  CHECK(run.code == 3);
  CHECK(says(run, "unknown key 'units'; it is called manipulation.length_unit since schema 1"));
}

TEST_CASE("scenes: a surface is flattened by a scene as by flags") {
  const Scratch scratch;
  const std::string model = scratch.path("model.obj");
  mesh::write_obj(model, mesh::procedural_face(8));
  const std::string scene = write_scene(
      scratch, {{"schema", 1},
                {"mesh", "model.obj"},
                {"energy", "arap"},
                {"parameterization",
                 {{"uv_units", "model"},
                  {"pins", {{{"vertex", 0}}, {{"vertex", 5}, {"target", {0.5, 0.25}}, {"soft", 2}}}}}},
                {"newton", {{"gradient_tolerance", 1e-6}}}});
  CHECK(parameterize({scene, "-o", scratch.path("scene"), "--no-picture"}).code == 0);
  CHECK(parameterize({model, "-o", scratch.path("flags"), "--no-picture", "-e", "arap", "--uv-units", "model",
                      "--pin", "0", "--soft-pin", "5:0.5,0.25:2", "--gradient-tolerance", "1e-6"})
            .code == 0);
  CHECK(read_file(scratch.path("scene/model_uv.obj")) == read_file(scratch.path("flags/model_uv.obj")));
}

TEST_CASE("scenes: two shapes are named by a scene, files beside it") {
  const Scratch scratch;
  const mesh::TetMesh bar = straight_bar(4);
  mesh::write_tets(scratch.path("first.msh"), bar);
  mesh::write_tets(scratch.path("second.msh"), twisted_and_bent(bar, 1, 0));
  const std::string scene = write_scene(
      scratch, {{"schema", 1}, {"mesh", "first.msh"}, {"second_mesh", "second.msh"}, {"frames", 3}});
  CHECK(interpolate({scene, "-o", scratch.path("scene")}).code == 0);
  CHECK(interpolate({scratch.path("first.msh"), scratch.path("second.msh"), "-o", scratch.path("files"),
                     "--frames", "3", "--no-picture"})
            .code == 0);
  CHECK(read_file(scratch.path("scene/frame_0002.vtu")) == read_file(scratch.path("files/frame_0002.vtu")));
}

TEST_CASE("--set reaches every key, and names itself where it is wrong") {
  const Scratch scratch;
  const std::string file = write_scene(scratch, twisted_bar(30, 1));
  const auto with = [&](const std::string& setting) {
    return deform({file, "-o", scratch.path("out"), "--no-picture", "--set", setting});
  };
  CHECK(with("newton.armijo=0.2").code == 0);
  const Json summary = Json::parse(read_file(scratch.path("out/summary.json")));
  CHECK(summary["scene"]["newton"]["armijo"] == 0.2);
  CHECK(says(with("newton.armijo=0.7"), "newton.armijo: must be a number > 0 and < 0.5, not 0.7"));
  CHECK(says(with("newton.armjo=0.2"), "newton: unknown key 'armjo'"));
  CHECK(says(with("energy.name.x=1"), "--set energy.name.x=1: there is something else"));
  CHECK(says(with("armijo"), "--set: 'armijo' is not of the form key=value"));
  CHECK(with("newton.projection=clamp").code == 0);
}

TEST_CASE("flags of the version before work with a notice") {
  const Scratch scratch;
  const std::string file = write_scene(scratch, swirl(90));
  const Outcome run = manipulate({file, "-o", scratch.path("out"), "--no-picture", "--gap", "1e-4",
                                  "--absolute", "--weights=unit", "--method", "skinning"});
  CHECK(says(run, "option --gap is --gap-tolerance now"));
  CHECK(says(run, "option --absolute is --length-unit=mesh now"));
  CHECK(says(run, "option --weights is --element-weights now"));
  CHECK(says(run, "option --method skinning is --method=unconstrained now"));
  const auto scene = read_json(scratch.path("out/summary.json"))["scene"]["manipulation"];
  CHECK(scene == nlohmann::json{{"gap_tolerance", 1e-4},
                                {"element_weights", "unit"},
                                {"length_unit", "mesh"},
                                {"method", "unconstrained"}});
}
