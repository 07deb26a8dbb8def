#include "body.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/handles/bounded_weights.hpp>
#include <isostretch/handles/selection.hpp>
#include <isostretch/mesh/generators.hpp>

#include <doctest/doctest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

using namespace isostretch;
using namespace isostretch::handles;

namespace {

using Handles = std::vector<std::vector<int>>;

using tests::Body;
using tests::body;

Body sheet(const mesh::SurfaceMesh& mesh) {
  const mesh::Points2 flat = mesh.vertices.leftCols<2>();
  return body(mesh::elements(flat, mesh.triangles), flat);
}
Body sheet(int n) {
  return sheet(mesh::crossed_grid(2 * n, n, 2, 1));
}
Body bar(int n) {
  const auto m = mesh::tet_bar(4 * n, n, n, 4, 1, 1);
  return body(mesh::elements(m), m.vertices);
}

// Both ends, and something in between, which makes bounds bite.
Handles three(const Nodes& nodes) {
  const Point high = nodes.positions.maxCoeff() * Point::UnitX();
  return {select(Slab{0, End::min, 0.01}, nodes, "low"), select(Slab{0, End::max, 0.01}, nodes, "high"),
          select(Nearest{{0.3 * high.x(), 0.5, 0.5}, 3}, nodes, "middle")};
}

// K M^-1 K w, computed without the library's matrices.
std::vector<double> biharmonic(const assembly::Elements& e, const std::vector<double>& w) {
  const auto laplacian = [&](const std::vector<double>& u) {
    std::vector<double> result(u.size(), 0.0);
    const int k = e.nodes_per_element;
    for (int t = 0; t < e.element_count(); ++t)
      for (int c = 0; c < e.dim; ++c) {
        const double* g = e.gradients.data() + t * k * e.dim;
        double slope = 0;
        for (int a = 0; a < k; ++a) slope += u[e.nodes[t * k + a]] * g[a * e.dim + c];
        for (int a = 0; a < k; ++a) result[e.nodes[t * k + a]] += e.weights[t] * slope * g[a * e.dim + c];
      }
    return result;
  };
  std::vector<double> mass(w.size(), 0.0), Kw = laplacian(w);
  for (std::size_t i = 0; i < e.nodes.size(); ++i)
    mass[e.nodes[i]] += e.weights[i / e.nodes_per_element] / e.nodes_per_element;
  for (std::size_t n = 0; n < w.size(); ++n) Kw[n] /= mass[n];
  return laplacian(Kw);
}

double largest_difference(const HandleWeights& a, const HandleWeights& b) {
  REQUIRE(a.values.size() == b.values.size());
  double worst = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    worst = std::max(worst, std::abs(a.values[i] - b.values[i]));
  return worst;
}

void check_partition(const HandleWeights& weights) {
  double worst = 0, least = 1, most = 0;
  for (int n = 0; n < weights.node_count(); ++n) {
    double sum = 0;
    for (int h = 0; h < weights.handles; ++h) {
      sum += weights.at(n, h);
      least = std::min(least, weights.at(n, h));
      most = std::max(most, weights.at(n, h));
    }
    worst = std::max(worst, std::abs(sum - 1));
  }
  CHECK(worst < 1e-15 * 8);
  CHECK(least >= 0);
  CHECK(most <= 1);
}

int zeros(const HandleWeights& weights, int handle) {
  int count = 0;
  for (int n = 0; n < weights.node_count(); ++n) count += weights.at(n, handle) == 0;
  return count;
}

std::string failure(const assembly::Elements& elements, const Handles& handles) {
  try {
    bounded_biharmonic_weights(elements, handles);
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing thrown";
}

}  // namespace

TEST_CASE("weights are 1 at their handle, 0 at others, within the bounds, and exactly 0 far away") {
  for (const Body& b : {sheet(10), bar(4)}) {
    const Handles handles = three(b.nodes);
    const HandleWeights weights = bounded_biharmonic_weights(b.elements, handles);
    check_partition(weights);
    for (int h = 0; h < 3; ++h) {
      const WeightReport& report = weights.reports[h];
      CHECK(report.kkt_residual < 1e-9);
      CHECK(report.iterations <= 12);
      CHECK(report.factorizations < report.iterations);
      for (int other = 0; other < 3; ++other)
        for (const int n : handles[other]) CHECK(weights.at(n, h) == (h == other ? 1 : 0));
      const std::size_t elsewhere = handles[(h + 1) % 3].size() + handles[(h + 2) % 3].size();
      CHECK(zeros(weights, h) == report.at_zero + static_cast<int>(elsewhere));
    }
    CHECK(weights.reports[1].at_zero > 20);
  }
}

TEST_CASE("two handles whose weights stay within the bounds solve the biharmonic equation") {
  // Without bounds the weights of two handles sum to 1; with ends alone they stay within.
  const Body b = bar(3);
  Handles handles = three(b.nodes);
  handles.pop_back();
  const HandleWeights weights = bounded_biharmonic_weights(b.elements, handles);
  CHECK(weights.reports[0].at_zero + weights.reports[1].at_zero == 0);
  std::vector<double> w(weights.values.size() / 2), delta(w.size(), 0.0);
  for (std::size_t n = 0; n < w.size(); ++n) w[n] = weights.values[2 * n];
  delta[w.size() / 2] = 1;
  const std::vector<double> g = biharmonic(b.elements, w);
  const double diagonal = biharmonic(b.elements, delta)[w.size() / 2];
  for (std::size_t n = 0; n < w.size(); ++n)
    if (w[n] != 0 && w[n] != 1) CHECK(std::abs(g[n]) < 1e-12 * diagonal);
}

TEST_CASE("two handles that make the bounds bite: gradient, signs and complementarity") {
  // With w, 1 - w is the weight of the other handle: rows sum to 1 before they are divided.
  const auto tets = mesh::tet_bar(16, 4, 4, 4, 1, 1);
  for (const Body& b : {sheet(12), body(mesh::elements(tets), tets.vertices)}) {
    const Handles handles{select(Slab{0, End::min, 0.01}, b.nodes, "end"),
                          select(Box{{0.5, 0.25, 0.25}, {0.7, 0.75, 0.75}}, b.nodes, "middle")};
    const HandleWeights weights = bounded_biharmonic_weights(b.elements, handles);
    CHECK(weights.reports[0].at_zero > 20);
    // Where neither the weight nor its gradient is beyond rounding, either is right.
    CHECK(std::abs(weights.reports[0].at_zero - weights.reports[1].at_one) <= 3);
    std::vector<bool> held(b.nodes.count(), false);
    for (const auto& handle : handles)
      for (const int n : handle) held[n] = true;
    for (int h = 0; h < 2; ++h) {
      std::vector<double> w(b.nodes.count()), delta(w.size(), 0.0);
      for (std::size_t n = 0; n < w.size(); ++n) w[n] = weights.at(static_cast<int>(n), h);
      delta[w.size() / 2] = 1;
      const double unit = biharmonic(b.elements, delta)[w.size() / 2];
      const std::vector<double> g = biharmonic(b.elements, w);
      double free = 0, at_zero = 0, at_one = 0, pressure = 0;
      for (std::size_t n = 0; n < w.size(); ++n) {
        if (held[n]) continue;
        if (w[n] > 0 && w[n] < 1) free = std::max(free, std::abs(g[n]));
        if (w[n] == 0) at_zero = std::max(at_zero, -g[n]);
        if (w[n] == 1) at_one = std::max(at_one, g[n]);
        if (w[n] == 0 || w[n] == 1) pressure = std::max(pressure, std::abs(g[n]));
      }
      CHECK(free < 1e-9 * unit);
      CHECK(at_zero < 1e-9 * unit);
      CHECK(at_one < 1e-9 * unit);
      CHECK(pressure > 1e-5 * unit);  // the bounds do push
    }
  }
}

TEST_CASE("few systems find the sets, and those that would come back are left by shorter steps") {
  const auto tets = mesh::quadruped(20);
  const Body b = body(mesh::elements(tets), tets.vertices);
  const HandleWeights weights = bounded_biharmonic_weights(b.elements, tests::scattered(b.nodes, 10));
  check_partition(weights);
  bool descended = false;
  for (const WeightReport& report : weights.reports) {
    CHECK(report.factorizations <= 20);
    CHECK(report.kkt_residual < 1e-9);
    CHECK(report.at_zero > 50);
    descended = descended || report.descended;
  }
  CHECK(descended);
}

TEST_CASE("a symmetric problem has symmetric weights") {
  const int n = 12;
  const Body b = sheet(mesh::crossed_grid(n, n));
  const Handles handles{select(Nearest{{0.25, 0.5, 0}, 1}, b.nodes, "left"),
                        select(Nearest{{0.75, 0.5, 0}, 1}, b.nodes, "right"),
                        select(Slab{1, End::max, 0.01}, b.nodes, "top")};
  const HandleWeights weights = bounded_biharmonic_weights(b.elements, handles);
  CHECK(weights.reports[0].at_zero > 0);
  for (int v = 0; v < weights.node_count(); ++v) {
    Point mirrored = b.nodes.at(v);
    mirrored.x() = 1 - mirrored.x();
    const int m = select(Nearest{mirrored, 1}, b.nodes, "mirror")[0];
    CHECK(std::abs(weights.at(v, 0) - weights.at(m, 1)) < 1e-8);
    CHECK(std::abs(weights.at(v, 2) - weights.at(m, 2)) < 1e-8);
  }
}

TEST_CASE("neither the size of the mesh nor the numbers of nodes matter") {
  const auto m = mesh::tet_bar(10, 4, 4, 10, 4, 4);
  const Body b = body(mesh::elements(m), m.vertices);
  const Handles handles = three(b.nodes);
  const HandleWeights weights = bounded_biharmonic_weights(b.elements, handles);
  for (const double scale : {1e-3, 1e3}) {
    auto other = m;
    other.vertices *= scale;
    const auto elements = assembly::elements_from(mesh::elements(other));
    CHECK(largest_difference(weights, bounded_biharmonic_weights(elements, handles)) < 1e-9);
  }
  std::vector<int> number(b.nodes.count());
  for (int n = 0; n < b.nodes.count(); ++n) number[n] = n;
  std::shuffle(number.begin(), number.end(), std::mt19937(7));
  assembly::Elements renumbered = b.elements;
  Handles moved = handles;
  for (int& n : renumbered.nodes) n = number[n];
  for (auto& handle : moved)
    for (int& n : handle) n = number[n];
  const HandleWeights other = bounded_biharmonic_weights(renumbered, moved);
  for (int n = 0; n < b.nodes.count(); ++n)
    for (int h = 0; h < 3; ++h) CHECK(std::abs(weights.at(n, h) - other.at(number[n], h)) < 1e-8);
}

TEST_CASE("weights are the same to the bit for any number of threads") {
  // The larger one is ordered by nested dissection, which draws random numbers.
  const auto tets = mesh::quadruped(28);
  for (const Body& b : {bar(4), body(mesh::elements(tets), tets.vertices)}) {
    const Handles handles = tests::scattered(b.nodes, 6);
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
    const HandleWeights one = bounded_biharmonic_weights(b.elements, handles);
    omp_set_num_threads(3);
    const HandleWeights many = bounded_biharmonic_weights(b.elements, handles);
    omp_set_num_threads(before);
    CHECK(one.values == many.values);
  }
}

TEST_CASE("one handle alone, handles on every node, and components of one handle need no solve") {
  const Body b = sheet(3);
  const HandleWeights alone = bounded_biharmonic_weights(b.elements, {{4}});
  for (const double w : alone.values) CHECK(w == 1);
  CHECK(alone.unreached.empty());

  Handles all(b.nodes.count());
  for (int n = 0; n < b.nodes.count(); ++n) all[n] = {n};
  const HandleWeights each = bounded_biharmonic_weights(b.elements, all);
  for (int n = 0; n < b.nodes.count(); ++n)
    for (int h = 0; h < each.handles; ++h) CHECK(each.at(n, h) == (n == h ? 1 : 0));

  // Three bars and a node of no element; the handles share the first bar, the second has one, the third
  // none.
  const mesh::TetMesh part = mesh::tet_bar(3, 1, 1);
  mesh::TetMesh three_bars;
  three_bars.vertices.resize(49, 3);
  three_bars.vertices << part.vertices, part.vertices.array() + 3, part.vertices.array() + 6,
      Eigen::RowVector3d(99, 9, 9);
  three_bars.tets.resize(54, 4);
  three_bars.tets << part.tets, part.tets.array() + 16, part.tets.array() + 32;
  const auto elements = assembly::elements_from(mesh::elements(three_bars));
  const HandleWeights parts = bounded_biharmonic_weights(elements, {{0}, {3, 20}});
  check_partition(parts);
  CHECK(parts.at(1, 0) > 0.5);
  CHECK(parts.at(1, 1) > 0);
  for (int n = 16; n < 32; ++n) CHECK(parts.at(n, 1) == 1);
  for (int n = 32; n < 49; ++n) CHECK(parts.at(n, 0) == 1);
  REQUIRE(parts.unreached.size() == 17);
  CHECK(parts.unreached.front() == 32);
  CHECK(parts.unreached.back() == 48);
}

TEST_CASE("misuse of weights is named") {
  const Body b = sheet(3);
  CHECK(failure(b.elements, {}).find("no handles") != std::string::npos);
  CHECK(failure(b.elements, {{1}, {}}).find("handle 1 has no nodes") != std::string::npos);
  CHECK(failure(b.elements, {{1}, {2, 9999}}).find("node 9999") != std::string::npos);
  CHECK(failure(b.elements, {{-1}}).find("node -1") != std::string::npos);
  const std::string shared = failure(b.elements, {{1, 5}, {2}, {5}});
  CHECK(shared.find("handle 2: node 5 belongs to handle 0") != std::string::npos);
  CHECK(failure(b.elements, {{1, 1}, {2}}) == "nothing thrown");
  WeightOptions options;
  options.tolerance = 0;
  CHECK_THROWS_WITH_AS(options.validate(), doctest::Contains("tolerance"), Error);
  options = {};
  options.max_iterations = 1;
  CHECK_THROWS_WITH_AS(bounded_biharmonic_weights(sheet(10).elements, three(sheet(10).nodes), options),
                       doctest::Contains("within 1 iterations"), Error);
}
