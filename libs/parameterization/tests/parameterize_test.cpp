#include <isostretch/core/error.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/parameterization/parameterize.hpp>
#include <isostretch/surface/orientation.hpp>

#include <doctest/doctest.h>

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
