// The reference instances of the inversion-free problem, whose optima are bracketed to 1e-10.
#include <isostretch/core/error.hpp>
#include <isostretch/mesh/element_arrays.hpp>
#include <isostretch/sdp_penalty/interior_point.hpp>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <string>

using namespace isostretch;
using nlohmann::json;
using sdp_penalty::Problem;

namespace {

assembly::Elements elements_of(const json& j) {
  const auto vertices = j["vertices"].get<std::vector<std::vector<double>>>();
  const auto elements = j["elements"].get<std::vector<std::vector<int>>>();
  if (j["dim"] == 2) {
    mesh::Points2 V(vertices.size(), 2);
    mesh::Triangles F(elements.size(), 3);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      for (std::size_t c = 0; c < 2; ++c) V(static_cast<int>(i), static_cast<int>(c)) = vertices[i][c];
    for (std::size_t i = 0; i < elements.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) F(static_cast<int>(i), static_cast<int>(c)) = elements[i][c];
    return assembly::elements_from(mesh::elements(V, F));
  }
  mesh::TetMesh mesh;
  mesh.vertices.resize(static_cast<int>(vertices.size()), 3);
  mesh.tets.resize(static_cast<int>(elements.size()), 4);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      mesh.vertices(static_cast<int>(i), static_cast<int>(c)) = vertices[i][c];
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (std::size_t c = 0; c < 4; ++c) mesh.tets(static_cast<int>(i), static_cast<int>(c)) = elements[i][c];
  return assembly::elements_from(mesh::elements(mesh));
}

Problem problem_of(const json& j) {
  Problem problem;
  problem.elements = elements_of(j);
  for (const auto& R : j["ex_rotations_rowmajor"])
    for (const double entry : R) problem.rotations.push_back(entry);
  problem.weights = j["element_weights"].is_null() ? sdp_penalty::unit_weights(problem.elements)
                                                   : j["element_weights"].get<std::vector<double>>();
  const auto ids = j["target_vertex_ids"].get<std::vector<int>>();
  const auto positions = j["target_positions"].get<std::vector<std::vector<double>>>();
  for (std::size_t h = 0; h < ids.size(); ++h) problem.targets.push_back({ids[h], positions[h]});
  problem.alpha = j["alpha"];
  problem.incompressibility =
      j["kappa_incompressibility"].is_null() ? 0.0 : double(j["kappa_incompressibility"]);
  return problem;
}

}  // namespace

TEST_CASE("reference optima: interior point, both margins") {
  const std::filesystem::path folder = std::string(ISOSTRETCH_SOURCE_DIR) + "/../shared/sdp";
  if (!std::filesystem::exists(folder)) {
    MESSAGE("skipped without the reference instances");
    return;
  }
  int seen = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".json") continue;
    ++seen;
    const json j = json::parse(std::ifstream(file.path()));
    const std::string name = j["name"];
    CAPTURE(name);
    Problem problem = problem_of(j);
    for (const std::string kind : {"sdp", "sdp_eps"}) {
      CAPTURE(kind);
      problem.margin = kind == "sdp" ? 0.0 : 1e-6;
      sdp_penalty::InteriorPointOptions options;
      options.gap_tolerance = 1e-8;
      Vector x;
      const auto summary = sdp_penalty::solve_interior_point(problem, x, options);
      const double lower = j[kind]["E_lower"], upper = j[kind]["E_upper"];
      MESSAGE(name << " " << kind << ": " << sdp_penalty::status_name(summary.status) << ", "
                   << summary.iterations << " iterations, " << summary.linear_solves << " solves, energy "
                   << summary.energy << ", gap " << summary.gap << ", " << summary.seconds << " s");
      CHECK(summary.status == sdp_penalty::Status::optimal);
      CHECK(summary.energy >= lower * (1 - 1e-9));
      CHECK(summary.energy <= upper * (1 + 2e-8));
      CHECK(summary.lower_bound <= upper * (1 + 1e-9));
      CHECK(summary.min_eigenvalue >= problem.margin);
      CHECK(summary.inverted == 0);
      CHECK(summary.trace.front().energy ==
            doctest::Approx(j["unconstrained"]["E"].get<double>()).epsilon(1e-9));
      CHECK(summary.linear_solves <= 22);
    }
  }
  CHECK(seen == 10);
}
