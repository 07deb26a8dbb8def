// isostretch-energy by its command line.
#include "failure.hpp"
#include "process.hpp"
#include "scratch.hpp"

#include <isostretch/energies/registry.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace isostretch;
using namespace isostretch::test;
using doctest::Approx;
using nlohmann::json;

namespace {

const std::string neo_hookean = "mu/2*(I2-d) - mu*log(J) + lambda/2*log(J)^2";

Outcome inspect(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), program("energy"));
  return run(arguments);
}

// summary.json of the energy.
json findings(std::vector<std::string> arguments) {
  const Scratch scratch;
  arguments.insert(arguments.end(), {"--out", scratch.path("out"), "--quiet"});
  const Outcome outcome = inspect(arguments);
  CAPTURE(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.out.empty());
  return read_json(scratch.path("out/summary.json"));
}

json in_space(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--dim", "3"});
  return findings(arguments)["studies"][0];
}

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("energy: small-strain moduli are the parameters, typed and built in") {
  for (const std::string& energy : {std::string("neo_hookean_log"), neo_hookean}) {
    const json summary = findings({energy, "--param", "mu=1.5,lambda=10"});
    CHECK(summary["has_barrier"] == true);
    CHECK(summary["energy_name"] == energy);
    CHECK(summary["energy_parameters"]["mu"] == 1.5);
    CHECK(summary["dimensions"] == json{2, 3});
    REQUIRE(summary["studies"].size() == 2);
    for (const json& study : summary["studies"]) {
      const json& rest = study["rest"];
      CHECK(rest["kind"] == "minimum");
      CHECK(rest["stress_free"] == true);
      CHECK(rest["mu"].get<double>() == Approx(1.5));
      CHECK(rest["lambda"].get<double>() == Approx(10));
      CHECK(rest["diagonal"].get<double>() == Approx(13));
      CHECK(std::abs(rest["twist"][0].get<double>()) < 1e-12);
      CHECK(study["formulas"].empty() == (energy == "neo_hookean_log"));
    }
  }
}

TEST_CASE("energy: rest may be stressed, degenerate, a saddle or outside") {
  const json stressed = in_space({"dirichlet"})["rest"];
  CHECK(stressed["kind"] == "stressed");
  CHECK(stressed["stress"][0].get<double>() == Approx(1));
  CHECK(stressed["twist"][0].get<double>() == Approx(1));
  CHECK(in_space({"mips_3d"})["rest"]["kind"] == "degenerate");
  CHECK(in_space({"0 - (I1 - 3)^2"})["rest"]["kind"] == "saddle");
  const json outside = in_space({"I2 - log(0.5 - J)"});
  CHECK(outside["rest"]["kind"] == "outside");
  CHECK(outside["convex"]["uniform"].is_null());
  CHECK(outside["negative"]["outside_of_domain"].get<int>() > 0);
}

TEST_CASE("energy: ARAP's twist is negative where two stretches add up to less than 2, and nothing else is") {
  const json study = in_space({"arap", "--range", "0.25:4"});
  const json& negative = study["negative"];
  const double samples = negative["samples"];
  CHECK(negative["flip"]["negative"] == 0);
  CHECK(negative["scaling"]["negative"] == 0);
  CHECK(negative["twist"]["share"].get<double>() ==
        Approx(negative["twist"]["negative"].get<double>() / samples));
  // 2 - 4 / (a + b) of the two smallest stretches.
  CHECK(negative["twist"]["least"].get<double>() == Approx(2 - 4 / 0.5));
  const json& at = negative["twist"]["at"];
  CHECK(at[1].get<double>() == Approx(0.25));
  CHECK(at[2].get<double>() == Approx(0.25));
  const json& convex = study["convex"];
  CHECK(convex["uniform"][0].get<double>() == Approx(1).epsilon(1e-6));
  CHECK(convex["uniform"][1] == 4);
  CHECK(convex["box"].get<double>() == Approx(1).epsilon(1e-6));
  CHECK(convex["box_without_twist"] == 4);
}

TEST_CASE("energy: where a convex range ends is found to many digits") {
  // The scaling eigenvalue of 2D is 2 - 6 k (s - 1) on uniform stretches, the twist its slope over s.
  const json study = findings({"sum((s - 1)^2 - k*(s - 1)^3)", "-p", "k=0.5", "--dim", "2"})["studies"][0];
  CHECK(study["convex"]["uniform"][1].get<double>() == Approx(1 + 1 / 1.5).epsilon(1e-8));
  CHECK(study["convex"]["box_without_twist"].get<double>() == Approx(1 + 1 / 1.5).epsilon(1e-6));
  // Dirichlet's energy is convex everywhere.
  const json dirichlet = in_space({"dirichlet"})["convex"];
  CHECK(dirichlet["uniform"] == json{0.3, 3.0});
  CHECK(dirichlet["box"] == dirichlet["largest_box"]);
}

TEST_CASE("energy: a name and the same energy typed have the same numbers") {
  const json built = in_space({"symmetric_dirichlet"}), typed = in_space({"sum(s^2 + 1/s^2)/2"});
  REQUIRE(built["examples"].size() == typed["examples"].size());
  REQUIRE(built["examples"].size() > 20);
  double factor = 0;
  for (std::size_t i = 0; i < built["examples"].size(); ++i) {
    const json &a = built["examples"][i], &b = typed["examples"][i];
    CHECK(a["stretches"] == b["stretches"]);
    if (factor == 0) factor = a["flip"][0].get<double>() / b["flip"][0].get<double>();
    for (const char* mode : {"twist", "flip", "scaling"})
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(a[mode][k].get<double>() == Approx(factor * b[mode][k].get<double>()).epsilon(1e-9));
  }
}

TEST_CASE("energy: the report, on the terminal and as files") {
  const Scratch scratch;
  const Outcome outcome =
      inspect({neo_hookean, "-p", "mu=1", "-p", "lambda=10", "--out", scratch.path("out")});
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  for (const char* words :
       {"barrier: infinite at det F <= 0", "2D and 3D", "free of stress", "twist", "uniaxial",
        "psi_J = (lambda*log(J) - mu)/J", "flip_1 = ", "At rest, in 2D", "At rest, in 3D", "wrote 6 files"})
    CHECK_MESSAGE(says(outcome.out, words), words);
  CHECK(scratch.contents() == std::vector<std::string>{"out", "out/maps_2d.png", "out/maps_2d.svg",
                                                       "out/maps_3d.png", "out/maps_3d.svg",
                                                       "out/report.html", "out/summary.json"});
  const std::string page = read_file(scratch.path("out/report.html"));
  for (const char* words : {"data:image/png;base64,", "psi_J", "Where the Hessian", "(lambda*log(J) - mu)/J"})
    CHECK_MESSAGE(says(page, words), words);
  CHECK(!says(page, "http"));
  CHECK(read_file(scratch.path("out/maps_2d.png")).starts_with("\x89PNG"));
  CHECK(says(read_file(scratch.path("out/maps_3d.svg")), "<svg"));
}

TEST_CASE("energy: without --out nothing is written, and the list is that of the registry") {
  const Outcome plain = inspect({"arap", "--dim", "2"});
  CHECK(plain.code == 0);
  CHECK(says(plain.out, "finite at any F"));
  CHECK(!says(plain.out, "in 3D"));
  const Outcome list = inspect({"--list-energies"});
  CHECK(list.code == 0);
  for (const std::string& name : energies::energy_names()) CHECK_MESSAGE(says(list.out, name), name);
}

TEST_CASE(
    "energy: an expression with s3 exists in space alone, and one that begins with a minus is no option") {
  const json summary = findings({"s1*s2*s3 + 1/(s1*s2*s3)"});
  CHECK(summary["dimensions"] == json{3});
  CHECK(summary["studies"].size() == 1);
  const Outcome minus = inspect({"--dim", "3", "--", "-log(J)"});
  CHECK(minus.code == 0);
  CHECK(says(minus.out, "psi_J = -1/J"));
}

TEST_CASE("energy: a wrong command line is exit code 2, a folder that cannot be made 4") {
  const Scratch scratch;
  const auto check = [&](const std::vector<std::string>& arguments, int code,
                         const std::vector<std::string>& words) {
    check_failure_of([](const auto& list) { return inspect(list); }, scratch, arguments, code, words);
  };
  check({}, 2, {"energy"});
  check({"rubber"}, 2, {"unknown energy 'rubber'", "arap"});
  check({"arap", "-p", "nu=1"}, 2, {"nu"});
  check({"mips_2d", "--dim", "3"}, 2, {"mips_2d", "3D"});
  check({"arap", "--dim", "4"}, 2, {"--dim"});
  for (const char* range : {"0.3", "0:3", "1:3", "0.3:1", "a:b", "0.3:3:4", "3:0.3", ""})
    check({"arap", "--range", range}, 2, {"--range"});
  check({"2*I2", "-p", "k=1"}, 2, {"'k'"});
  const std::string file = scratch.write("file", "");
  check({"arap", "--out", file + "/out"}, 4, {"file/out"});
}

TEST_CASE("energy: what is wrong with an expression is shown with a caret") {
  const Outcome outcome = inspect({"I2 + * 3"});
  CHECK(outcome.code == 2);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.starts_with("error: "));
  CHECK(outcome.err.ends_with("\n  I2 + * 3\n       ^\n"));
}
