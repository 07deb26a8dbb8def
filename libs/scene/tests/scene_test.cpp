#include <isostretch/core/error.hpp>
#include <isostretch/scene/comparison_limits.hpp>
#include <isostretch/scene/handle_text.hpp>
#include <isostretch/scene/option_values.hpp>
#include <isostretch/scene/pipelines.hpp>
#include <isostretch/scene/scene_file.hpp>
#include <isostretch/scene/solid.hpp>

#include <paths.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

using namespace isostretch;
using scene::Node;
using scene::Value;

namespace {

Value parsed(const std::string& text) {
  return scene::parse_json(text, "test");
}

std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

// What `before` becomes.
void check_upgrade(const std::string& before, const std::string& after) {
  CAPTURE(before);
  Value value = parsed(before);
  CHECK_FALSE(scene::upgrade(value).empty());
  CHECK(scene::to_json(value) == scene::to_json(parsed(after)));
  CHECK_NOTHROW(scene::check_keys(value));
}

std::string content(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

// The file holds what the library makes; with ISOSTRETCH_UPDATE it is written anew.
void check_generated(const char* name, const std::string& text) {
  const std::string file = tests::source_path(name);
  if (std::getenv("ISOSTRETCH_UPDATE") != nullptr) std::ofstream(file, std::ios::binary) << text;
  CHECK_MESSAGE(content(file) == text,
                std::string(name)
                    << " is not what the options say: run isostretch_scene_tests with ISOSTRETCH_UPDATE=1");
}

std::string section(const char* title, const char* text, const std::vector<OptionField>& fields,
                    const char* prefix) {
  return std::string("\n## ") + title + "\n\n" + text +
         "\n\n| key | value | default | what it does |\n| --- | --- | --- | --- |\n" +
         scene::options_table(fields, prefix);
}

std::string option_tables() {
  newton::Options newton;
  deformation::ManipulationOptions manipulation;
  deformation::InterpolationOptions interpolation;
  parameterization::Options parameterization;
  scene::ComparisonLimits limits;
  return std::string(
             "# Options\n\nThese are the options that scenes have in objects of their own. The page is made "
             "of "
             "what the options say of themselves\nin the code, as the flags of the programs and the JSON "
             "Schema "
             "of scenes are. A flag has the last part of a key's name with - for _.\nOptions without a flag "
             "are "
             "set by `--set`, such as `--set newton.armijo=1e-3`.\n") +
         section("newton",
                 "How energies are minimised: `isostretch-deform`, `isostretch-interpolate`, "
                 "`isostretch-parameterize`.",
                 option_fields(newton), "newton.") +
         section("manipulation", "`isostretch-manipulate`.", option_fields(manipulation), "manipulation.") +
         section("interpolation",
                 "`isostretch-interpolate`, which has other defaults of `newton`: the projection "
                 "progressive, the "
                 "ordering amd, and\n1e-6 for the relative energy tolerance.",
                 scene::interpolation_fields(interpolation), "interpolation.") +
         section("parameterization", "`isostretch-parameterize`.",
                 scene::parameterization_fields(parameterization), "parameterization.") +
         section("limits", "`isostretch-compare`.", option_fields(limits), "limits.");
}

}  // namespace

TEST_CASE("older scenes are brought up to the present schema") {
  check_upgrade(
      R"({"guess": "rest", "solver": {"projection": "clamp", "backend": "pcg", "ordering": "amd"}})",
      R"({"initial_guess": "rest",
                    "newton": {"projection": "clamp", "linear_solver": {"backend": "pcg", "ordering": "amd"}}})");
  check_upgrade(R"({"alpha": 1, "units": "mesh", "penalty": "cubic", "method": "penalty", "gap": 1e-3})",
                R"({"manipulation": {"alpha": 1, "length_unit": "mesh", "method": "penalty",
                                     "gap_tolerance": 1e-3, "penalty": {"penalty": "cubic"}}})");
  check_upgrade(R"({"method": "skinning"})", R"({"manipulation": {"method": "unconstrained"}})");
  check_upgrade(R"({"solver": "ipopt", "max_iterations": 9})",
                R"({"manipulation": {"max_iterations": 9}, "rival": "ipopt"})");
  check_upgrade(R"({"problems": [{"name": "a", "guess": "rest"}], "max_iterations": 9, "time_limit": 1})",
                R"({"problems": [{"name": "a", "initial_guess": "rest"}],
                    "limits": {"max_iterations": 9, "time_limit": 1}})");
}

TEST_CASE("a moved key is called as it was written") {
  Value value = parsed(R"({"handles": [{"select": "all"}], "alpha": -1})");
  const auto renamed = scene::upgrade(value);
  CHECK(scene::renamed_text(renamed) ==
        "the scene has no \"schema\": 1, and is read as an older one: 'alpha' is now 'manipulation.alpha'");
  CHECK(error_of([&] { scene::read_manipulation(Node(value), 3); }) == "alpha: must be a number > 0, not -1");
}

TEST_CASE("scenes of the present schema are left as they are") {
  const Value before = parsed(R"({"schema": 1, "newton": {"projection": "clamp"}})");
  Value value = before;
  CHECK(scene::upgrade(value).empty());
  CHECK(value == before);
  CHECK(scene::renamed_text({}).empty());
}

TEST_CASE("versions and keys that there are not are refused") {
  Value two = parsed(R"({"schema": 2})");
  CHECK(error_of([&] { scene::upgrade(two); }) == "schema: must be 1, the only one there is, not 2");
  CHECK(error_of([] { scene::check_keys(parsed(R"({"schema": 1, "units": "mesh"})")); }) ==
        "unknown key 'units'; it is called manipulation.length_unit since schema 1");
  CHECK_THROWS_WITH_AS(scene::check_keys(parsed(R"({"handels": []})")),
                       doctest::Contains("unknown key 'handels'; there are schema, mesh"), Error);
  Value both = parsed(R"({"alpha": 1, "manipulation": {"alpha": 2}})");
  CHECK(error_of([&] { scene::upgrade(both); }) == "alpha: is now 'manipulation.alpha', which is given, too");
  Value other = parsed(R"({"alpha": 1, "manipulation": 3})");
  CHECK(error_of([&] { scene::upgrade(other); }) ==
        "alpha: is now 'manipulation.alpha', where something else is");
}

TEST_CASE("a gradient that is asked for is the only test of convergence") {
  const auto read = [](const std::string& text) {
    newton::Options options;
    options.relative_energy_tolerance = 1e-6;
    const Value value = parsed(text);
    scene::read_newton(Node(value), options);
    return options;
  };
  CHECK(read("{}").scaled_gradient_tolerance == newton::Options().scaled_gradient_tolerance);
  const newton::Options alone = read(R"({"newton": {"gradient_tolerance": 1e-5}})");
  CHECK(alone.gradient_tolerance == 1e-5);
  CHECK(alone.scaled_gradient_tolerance == 0);
  CHECK(alone.relative_energy_tolerance == 0);
  CHECK(read(R"({"newton": {"gradient_tolerance": 1e-5, "scaled_gradient_tolerance": 1e-7}})")
            .scaled_gradient_tolerance == 1e-7);
}

TEST_CASE("options that do not go together are refused by their keys") {
  const auto manipulation = [](const std::string& text) {
    return error_of([&] {
      const Value value = parsed(R"({"handles": [{"select": "all"}], "manipulation": )" + text + "}");
      scene::read_manipulation(Node(value), 3);
    });
  };
  CHECK(manipulation(R"({"largest_stretch": 2, "method": "pennon"})") ==
        "manipulation.largest_stretch: is known to the method interior_point alone");
  CHECK(manipulation(R"({"penalty": {"penalty": "cubic"}})") ==
        "manipulation.penalty: is of the method penalty alone");
  CHECK(manipulation(R"({"margin": 1})") == "manipulation.margin: must be a number >= 0 and < 1, not 1");
  const auto parameterization = [](const std::string& text) {
    return error_of([&] {
      const Value value = parsed(R"({"parameterization": )" + text + "}");
      scene::read_parameterization(Node(value));
    });
  };
  CHECK(parameterization(R"({"pins": [{"vertex": 3}, {"vertex": 3, "target": [0, 0]}]})") ==
        "parameterization.pins[1]: the vertex is pinned twice");
  CHECK(parameterization(R"({"pins": [{"vertex": 3, "soft": 1}]})") ==
        "parameterization.pins[0]: a soft pin needs a target");
  CHECK(parameterization(R"({"aligned": [{"vertices": [1, 2], "line": "level"}]})") ==
        "parameterization.aligned[0].line: unknown 'level'; there are horizontal, vertical");
  CHECK(parameterization(R"({"corners": [1, 2, 3, 4]})") == "corners: only with boundary square");
}

TEST_CASE("handles hold softly or hard as they say, and as the app has it otherwise") {
  const auto weight = [](const std::string& text, scene::Holding holding) {
    const Value value = parsed(R"({"handles": [)" + text + "]}");
    return scene::read_handle_script(Node(value), 3, holding, 1).handles.at(0).soft;
  };
  constexpr auto hard = scene::Holding::hard, soft = scene::Holding::soft;
  CHECK_FALSE(weight(R"({"select": "all"})", hard).has_value());
  CHECK(weight(R"({"select": "all", "soft": 3})", hard) == 3);
  CHECK(weight(R"({"select": "all", "hard": false})", hard) == 1);
  CHECK(weight(R"({"select": "all"})", soft) == 1);
  CHECK_FALSE(weight(R"({"select": "all", "hard": true})", soft).has_value());
  CHECK(error_of([&] { weight(R"({"select": "all", "soft": 3, "hard": true})", hard); }) ==
        "handles[0].hard: give either soft or hard");
  CHECK(error_of([&] { weight(R"({"select": "all", "soft": 3})", soft); }) ==
        "handles[0].soft: handles are soft here, all with the weight 'alpha'");
}

TEST_CASE("handles of a command line are those of a scene") {
  CHECK(scene::to_json(scene::handle_from_text("slab:x,max,0.1;rotate=0,0,1:90;soft=10")) ==
        R"({"select":{"slab":{"axis":"x","end":"max","fraction":0.1}},)"
        R"("rotate":{"axis":[0,0,1],"degrees":90},"soft":10})");
  CHECK(scene::to_json(scene::handle_from_text("vertices:3,4;hard")) ==
        R"({"select":{"vertices":[3,4]},"hard":true})");
  CHECK(error_of([] { scene::handle_from_text("slab:x,max"); }) ==
        "--handle: 'slab:x,max' is not slab:AXIS,min|max,FRACTION");
}

TEST_CASE("the names in the schema are those of the code") {
  const Value schema = scene::scene_schema();
  const auto names = [&](const Value& choice) {
    std::vector<std::string> all;
    for (const Value& item : choice.find("enum")->items()) all.push_back(item.text());
    return all;
  };
  const Value& properties = *schema.find("properties");
  CHECK(names(*properties.find("initial_guess")) == all_names(choice_names(deformation::InitialGuess{})));
  CHECK(properties.find("schema")->find("const")->number() == scene::schema_version);
  const Value& bar = *schema.find("$defs")->find("bar")->find("properties");
  CHECK(names(*bar.find("element")) == deformation::shape_names());
}

TEST_CASE("the published schema and the tables of options are those of the code") {
  check_generated("libs/scene/scene.schema.json", scene::to_json(scene::scene_schema(), 2) + "\n");
  check_generated("docs/options.md", option_tables());
}
