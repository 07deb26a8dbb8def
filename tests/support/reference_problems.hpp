#pragma once

// The reference instances of the inversion-free problem: three that are in the repository, seven in the
// outside data.
#include "conditional.hpp"

#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace isostretch::tests {

inline assembly::Elements elements_of(const nlohmann::json& j) {
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

inline sdp_penalty::Problem problem_of(const nlohmann::json& j) {
  sdp_penalty::Problem problem;
  problem.elements = elements_of(j);
  const auto dim = static_cast<std::size_t>(problem.dim());
  for (const auto& R : j["ex_rotations_rowmajor"])
    for (std::size_t k = 0; k < R.size(); ++k) problem.rotations.push_back(R[k % dim * dim + k / dim]);
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

struct Reference {
  std::string name;
  nlohmann::json json;
  sdp_penalty::Problem problem;  // margin 0
  Vector rest;
};

inline Vector rest_of(const nlohmann::json& j) {
  const auto vertices = j["vertices"].get<std::vector<std::vector<double>>>();
  const auto dim = static_cast<std::size_t>(j["dim"]);
  Vector rest(static_cast<Eigen::Index>(vertices.size() * dim));
  for (std::size_t i = 0; i < vertices.size() * dim; ++i)
    rest[static_cast<Eigen::Index>(i)] = vertices[i / dim][i % dim];
  return rest;
}

// By name, those of a folder that `known` does not have.
inline std::vector<Reference> references_in(const std::string& folder,
                                            const std::vector<Reference>& known = {}) {
  std::vector<Reference> result;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".json") continue;
    nlohmann::json json = nlohmann::json::parse(std::ifstream(file.path()));
    std::string name = json["name"];
    if (std::any_of(known.begin(), known.end(), [&](const Reference& r) { return r.name == name; })) continue;
    sdp_penalty::Problem problem = problem_of(json);
    Vector rest = rest_of(json);
    result.push_back({std::move(name), std::move(json), std::move(problem), std::move(rest)});
  }
  std::sort(result.begin(), result.end(),
            [](const Reference& a, const Reference& b) { return a.name < b.name; });
  return result;
}

// Those of the repository, by name.
inline std::vector<Reference> references() {
  std::vector<Reference> result = references_in(source_path("tests/golden/sdp"));
  REQUIRE(result.size() == 3);
  return result;
}

// Those of the outside data, by name: for cases decorated with outside_data({"sdp"}).
inline std::vector<Reference> outside_references() {
  std::vector<Reference> result = references_in(outside_path("sdp"), references());
  REQUIRE(result.size() == 7);
  return result;
}

}  // namespace isostretch::tests
