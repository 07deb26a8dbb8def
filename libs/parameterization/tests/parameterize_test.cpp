#include <isostretch/core/error.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/parameterization/parameterize.hpp>
#include <isostretch/surface/orientation.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::parameterization;

namespace {

const energies::AnyEnergy& symmetric_dirichlet() {
  static const energies::AnyEnergy energy = energies::make_energy("symmetric_dirichlet");
  return energy;
}

}  // namespace

TEST_CASE("parameterize: a closed surface becomes charts in the unit square, no triangle turned over") {
  const mesh::SurfaceMesh model = mesh::icosphere(3);
  const Parameterization result = parameterize(model, symmetric_dirichlet());
  CHECK(result.succeeded({}));
  CHECK(result.domain.closed);
  CHECK(result.layout.flipped.empty());
  CHECK(result.layout.overlap.triangles.empty());
  CHECK(result.layout.uv.minCoeff() >= 0);
  CHECK(result.layout.uv.maxCoeff() <= 1);
  const mesh::SurfaceMesh textured = result.textured();
  CHECK(textured.vertices == model.vertices);
  CHECK(textured.triangles == model.triangles);
  CHECK(mesh::count_flipped(textured.uv, textured.uv_triangles) == 0);
  for (const char* phase : {"domain", "start", "solve", "overlap", "layout"})
    CHECK(result.times.seconds(phase) > 0);
}

TEST_CASE("parameterize: progress is shown, and a request to stop leaves the best layout so far") {
  const StopSource source;
  int shown = 0;
  const Monitor monitor{source.token(), [&](const std::string&) {
                          if (++shown == 2) source.request_stop();
                        }};
  const Parameterization result = parameterize(mesh::procedural_face(20), symmetric_dirichlet(), {}, monitor);
  CHECK(result.solution.summary.outcome() == SolveStatus::interrupted);
  CHECK_FALSE(result.succeeded({}));
  CHECK(result.layout.flipped.empty());
}

TEST_CASE("parameterize: options that make no sense are refused by name") {
  const mesh::SurfaceMesh face = mesh::procedural_face(6);
  const auto refused = [&](const Options& options) {
    try {
      parameterize(face, symmetric_dirichlet(), options);
    } catch (const OptionError& error) {
      CHECK(error.kind() == ErrorKind::misuse);
      return error.option();
    }
    return std::string();
  };
  Options options;
  options.corners = {0, 1, 2, 3};
  CHECK(refused(options) == "corners");
  options = {};
  options.max_distortion = 0.5;
  CHECK(refused(options) == "max_distortion");
  options = {};
  options.pins = {{100000, {}}};
  CHECK(refused(options) == "pin");
  options = {};
  options.aligned = {{{3}, true}};
  CHECK(refused(options) == "horizontal");
  options = {};
  options.margin = 1;
  CHECK(refused(options) == "margin");
  options = {};
  options.overlap = OverlapRule::split;
  options.pack = parameterization::Pack::none;
  CHECK(refused(options) == "overlap");
  CHECK(refused({}).empty());
}

TEST_CASE("parameterize: meshes that no reader would let through are refused by vertex or triangle") {
  const auto refused = [](const mesh::SurfaceMesh& model, const Options& options = {}) {
    try {
      parameterize(model, symmetric_dirichlet(), options);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refused({}).find("there is no triangle") != std::string::npos);
  mesh::SurfaceMesh model = mesh::grid(2, 2);
  model.vertices(3, 1) = std::nan("");
  CHECK(refused(model).find("vertex 3") != std::string::npos);
  model = mesh::grid(2, 2);
  model.triangles(5, 0) = 100;
  CHECK(refused(model).find("triangle 5") != std::string::npos);
  model = mesh::grid(2, 2);
  model.vertices.row(4) = model.vertices.row(1);
  CHECK(refused(model).find("triangle") != std::string::npos);  // of no area
  model = mesh::grid(2, 2);
  model.uv = model.vertices.leftCols<2>();
  model.uv_triangles = model.triangles.topRows(2);
  Options from_input;
  from_input.initial = Initial::input;
  CHECK(refused(model, from_input).find("2 uv triangles for 8") != std::string::npos);
  model.uv_triangles = model.triangles;
  model.uv(0, 0) = std::nan("");
  CHECK(refused(model, from_input).find("uv point 0") != std::string::npos);
  model.uv = model.vertices.leftCols<2>();
  CHECK(refused(model, from_input).empty());
}
