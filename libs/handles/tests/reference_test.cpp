// Weights and rotations of the reference instances of the inversion-free problem.
#include "conditional.hpp"

#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/handles/bounded_weights.hpp>
#include <isostretch/handles/rotation_blend.hpp>
#include <isostretch/mesh/generators.hpp>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace isostretch;
using namespace isostretch::handles;
using isostretch::tests::outside_data;
using isostretch::tests::outside_path;
using nlohmann::json;

namespace {

assembly::Elements elements_of(const json& j) {
  const auto vertices = j["vertices"].get<std::vector<std::vector<double>>>();
  const auto elements = j["elements"].get<std::vector<std::vector<int>>>();
  if (j["dim"] == 2) {
    mesh::Points2 V(vertices.size(), 2);
    mesh::Triangles F(elements.size(), 3);
    for (std::size_t i = 0; i < vertices.size(); ++i) V.row(i) << vertices[i][0], vertices[i][1];
    for (std::size_t i = 0; i < elements.size(); ++i)
      F.row(i) << elements[i][0], elements[i][1], elements[i][2];
    return assembly::elements_from(mesh::elements(V, F));
  }
  mesh::TetMesh mesh;
  mesh.vertices.resize(vertices.size(), 3);
  mesh.tets.resize(elements.size(), 4);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    mesh.vertices.row(i) << vertices[i][0], vertices[i][1], vertices[i][2];
  for (std::size_t i = 0; i < elements.size(); ++i)
    mesh.tets.row(i) << elements[i][0], elements[i][1], elements[i][2], elements[i][3];
  return assembly::elements_from(mesh::elements(mesh));
}

AxisAngle axis_angle_of(const json& rotation) {
  if (rotation.is_number()) return {Point::UnitZ(), rotation.get<double>() * 180 / std::numbers::pi};
  const auto q = rotation.get<std::vector<double>>();
  const Point vector(q[1], q[2], q[3]);
  if (vector.isZero(0)) return {};
  return {vector, 2 * std::atan2(vector.norm(), q[0]) * 180 / std::numbers::pi};
}

HandleWeights weights_of(const json& j) {
  HandleWeights weights;
  weights.handles = static_cast<int>(j["handles"].size());
  for (const auto& row : j["bbw_weights"])
    for (const double w : row) weights.values.push_back(w);
  return weights;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

template <class Check>
void for_each_instance(const Check& check) {
  int seen = 0;
  for (const auto& file : std::filesystem::directory_iterator(outside_path("sdp"))) {
    if (file.path().extension() != ".json") continue;
    ++seen;
    const json j = json::parse(std::ifstream(file.path()));
    const std::string name = j["name"];
    CAPTURE(name);
    check(j);
  }
  CHECK(seen == 10);
}

}  // namespace

TEST_CASE("weights of the reference instances" * outside_data({"sdp"})) {
  for_each_instance([](const json& j) {
    std::vector<std::vector<int>> handles;
    for (const auto& handle : j["handles"]) handles.push_back(handle["vertices"].get<std::vector<int>>());
    const HandleWeights weights = bounded_biharmonic_weights(elements_of(j), handles);
    CHECK(largest_difference(weights.values, weights_of(j).values) < 1e-6);
    for (const WeightReport& report : weights.reports) CHECK(report.kkt_residual < 1e-9);
  });
}

TEST_CASE("rotations of the reference instances from their weights" * outside_data({"sdp"})) {
  for_each_instance([](const json& j) {
    std::vector<AxisAngle> axis_angles;
    for (const auto& handle : j["handles"]) axis_angles.push_back(axis_angle_of(handle["rotation"]));
    std::vector<double> expected;
    for (const auto& R : j["ex_rotations_rowmajor"]) {
      const std::size_t dim = R.size() == 4 ? 2 : 3;
      for (std::size_t k = 0; k < R.size(); ++k) expected.push_back(R[k % dim * dim + k / dim]);
    }
    // Those in the plane too were blended by half angles.
    const auto rotations =
        blended_rotations(elements_of(j), weights_of(j), axis_angles, RotationBlend::quaternion);
    CHECK(largest_difference(rotations, expected) < 1e-9);
  });
}

TEST_CASE("some weights of yogurt90_N6: a sheet held at its boundary, a disc in the middle turned") {
  const auto sheet = mesh::crossed_grid(6, 6);
  const mesh::Points2 flat = sheet.vertices.leftCols<2>();
  const std::vector<int> boundary{0,  1,  2,  3,  4,  5,  6,  7,  13, 14, 20, 21,
                                  27, 28, 34, 35, 41, 42, 43, 44, 45, 46, 47, 48};
  const std::vector<int> middle{24, 63, 64, 69, 70};
  const HandleWeights weights = bounded_biharmonic_weights(
      assembly::elements_from(mesh::elements(flat, sheet.triangles)), {boundary, middle});
  const std::vector<std::pair<int, double>> golden{
      {8, 0.09447923465608445}, {9, 0.2690338129484064},  {16, 0.7102880197430467}, {17, 0.9278066144103163},
      {56, 0.3394641457323509}, {57, 0.5893749908067757}, {71, 0.5893749908067752}};
  for (const auto& [node, value] : golden) CHECK(std::abs(weights.at(node, 1) - value) < 1e-9);
}
