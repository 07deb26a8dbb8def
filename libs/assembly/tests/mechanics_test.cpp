// The linear maps between nodes, elements and matrix that assembly is made of, against dense algebra.
#include <isostretch/assembly/block_assembler.hpp>
#include <isostretch/assembly/deformation_operator.hpp>
#include <isostretch/assembly/operators.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/fem/elements.hpp>
#include <isostretch/fem/quadratic.hpp>
#include <isostretch/mesh/generators.hpp>

#include <doctest/doctest.h>
#include <omp.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace isostretch;
using assembly::BlockAssembler;
using assembly::Elements;
using assembly::Restriction;

namespace {

const mesh::TetMesh& bar() {
  static const mesh::TetMesh mesh = mesh::tet_bar(3, 2, 2, 1.5, 1.0, 1.0);
  return mesh;
}

std::vector<double> random_numbers(std::size_t count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> result(count);
  for (double& value : result) value = uniform(generator);
  return result;
}

// Every corner and point of 10-node tets, where elements have more than one point.
template <class Body>
void for_every_point(const Elements& elements, const Body& body) {
  for (std::size_t e = 0; e < static_cast<std::size_t>(elements.element_count()); ++e)
    for (std::size_t p = 0; p < static_cast<std::size_t>(elements.points_per_element); ++p)
      body(e, e * static_cast<std::size_t>(elements.points_per_element) + p);
}

assembly::HessianPattern pattern_of(const Restriction& restriction, int dim) {
  assembly::PatternBuilder builder(restriction.node_count());
  restriction.add_stencil(builder);
  return {assembly::FreeUnknowns(dim, restriction.node_count()), std::move(builder)};
}

Eigen::MatrixXd lower_part(const assembly::HessianPattern& pattern, const std::vector<double>& values) {
  const sparse::SymmetricMatrix& matrix = pattern.zero_matrix();
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(matrix.size, matrix.size);
  for (int j = 0; j < matrix.size; ++j)
    for (auto k = static_cast<std::size_t>(matrix.column_start[static_cast<std::size_t>(j)]);
         k < static_cast<std::size_t>(matrix.column_start[static_cast<std::size_t>(j) + 1]); ++k)
      dense(matrix.row[k], j) = values[k];
  return dense;
}

}  // namespace

TEST_CASE("the deformation gradient of a linear map is the map, exactly 0 for translations") {
  const Elements elements = assembly::elements_from(mesh::elements(mesh::quadratic(bar())));
  const mesh::QuadraticTetMesh quadratic = mesh::quadratic(bar());
  const Eigen::Matrix3d A = Eigen::Matrix3d::Random();
  std::vector<double> x(static_cast<std::size_t>(3 * elements.node_count)), shift(x.size(), 0.1);
  for (int n = 0; n < elements.node_count; ++n) {
    const Eigen::Vector3d moved = A * quadratic.nodes.row(n).transpose();
    for (int r = 0; r < 3; ++r) x[static_cast<std::size_t>(3 * n + r)] = moved[r];
  }
  const assembly::DeformationOperator<3> deformation(elements);
  for_every_point(elements, [&](std::size_t, std::size_t point) {
    const linalg::Mat<3> F = deformation.apply(point, x.data()),
                         none = deformation.apply(point, shift.data());
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        CHECK(F[r][c] == doctest::Approx(A(r, c)).epsilon(1e-12));
        CHECK(none[r][c] == 0);
      }
  });
}

TEST_CASE("the batch of deformation gradients and the determinants are those of single points") {
  const Elements elements = assembly::elements_from(mesh::elements(mesh::quadratic(bar())));
  const auto x = random_numbers(static_cast<std::size_t>(3 * elements.node_count), 1);
  const std::size_t first = 5, count = 20, stride = 24;
  std::vector<double> F(9 * stride, -7.0);
  assembly::deformation_gradients(elements, x.data(), first, count, F.data(), stride);
  const std::vector<double> determinants = assembly::determinants(elements, x.data());
  REQUIRE(determinants.size() == elements.weights.size());
  const assembly::DeformationOperator<3, 10> deformation(elements);
  for (std::size_t i = 0; i < count; ++i) {
    const linalg::Mat<3> one = deformation.apply(first + i, x.data());
    CHECK(determinants[first + i] == linalg::determinant(one));
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) CHECK(F[(r + 3 * c) * stride + i] == one.m[r][c]);
  }
  CHECK(F[count] == -7);  // beyond the count nothing is written
}

TEST_CASE("forces on corners, summed at nodes, are the transpose of the deformation gradients") {
  const Elements elements = assembly::elements_from(mesh::elements(bar()));
  const Restriction restriction(elements);
  const auto x = random_numbers(static_cast<std::size_t>(3 * elements.node_count), 2);
  const auto P = random_numbers(9 * elements.weights.size(), 3);
  const assembly::DeformationOperator<3, 4> deformation(elements);
  std::vector<double> corners(3 * elements.nodes.size()), g(x.size(), 0.5);
  double inner = 0;
  for_every_point(elements, [&](std::size_t e, std::size_t point) {
    const linalg::Mat<3> Pe = linalg::from_rows<3>(P.data() + 9 * point);
    inner += inner_product(Pe, deformation.apply(point, x.data()));
    deformation.apply_transposed(point, Pe, [&](int a, int r, double value) {
      corners[(4 * e + static_cast<std::size_t>(a)) * 3 + static_cast<std::size_t>(r)] = value;
    });
  });
  restriction.add_transposed(3, corners.data(), g.data());
  double outer = 0;
  for (std::size_t i = 0; i < x.size(); ++i) outer += (g[i] - 0.5) * x[i];
  CHECK(outer == doctest::Approx(inner).epsilon(1e-12));
}

TEST_CASE("blocks of elements, stored or computed, add up to the dense matrix for any number of threads") {
  const mesh::TetMesh large = mesh::tet_bar(12, 12, 12);  // more blocks than a thread is worth
  const Elements elements = assembly::elements_from(mesh::elements(large));
  const Restriction restriction(elements);
  const assembly::HessianPattern pattern = pattern_of(restriction, 3);
  REQUIRE(pattern.block_count() > 4000);
  const BlockAssembler blocks(restriction, pattern);
  const std::size_t per_element = 9 * BlockAssembler::pairs(4), count = restriction.element_count();
  std::vector<double> stored = random_numbers(per_element * count, 4);
  const auto slot = [&](std::size_t e, int a, int b) {
    return stored.data() + e * per_element + static_cast<std::size_t>(9 * (a * 4 - a * (a - 1) / 2 + b - a));
  };
  for (std::size_t e = 0; e < count; ++e)
    for (int a = 0; a < 4; ++a)  // diagonal blocks are symmetric
      for (int r = 0; r < 3; ++r)
        for (int s = 0; s < r; ++s) slot(e, a, a)[3 * r + s] = slot(e, a, a)[3 * s + r];
  const std::size_t size = pattern.zero_matrix().value.size();
  std::vector<double> values(size, 0.0), computed(size, 0.0), alone(size, 0.0);
  blocks.add_stored(stored.data(), values.data());
  blocks.add_computed<3, 4>(
      [&](std::size_t e, int a, int b, linalg::Mat<3>& sum) {
        const linalg::Mat<3> K = linalg::from_rows<3>(slot(e, std::min(a, b), std::max(a, b)));
        sum += a <= b ? K : transposed(K);
      },
      computed.data());
  CHECK(values == computed);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  blocks.add_stored(stored.data(), alone.data());
  omp_set_num_threads(threads);
  CHECK(values == alone);

  std::vector<double> expected(size, 0.0);
  for (std::size_t e = 0; e < count; ++e)
    for (int a = 0; a < 4; ++a)
      for (int b = a; b < 4; ++b) {
        const int* node = restriction.nodes(e);
        const int* positions = pattern.positions(pattern.block(node[a], node[b]));
        for (int r = 0; r < 3; ++r)
          for (int s = 0; s < 3; ++s) {
            const int position = positions[node[a] >= node[b] ? 3 * r + s : 3 * s + r];
            if (position >= 0) expected[static_cast<std::size_t>(position)] += slot(e, a, b)[3 * r + s];
          }
      }
  CHECK(values == expected);
}

TEST_CASE("a node that an element has twice gets both blocks of the pair") {
  const Restriction restriction({0, 1, 1}, 3, 2);
  const assembly::HessianPattern pattern = pattern_of(restriction, 2);
  const BlockAssembler blocks(restriction, pattern);
  const Eigen::MatrixXd random = Eigen::MatrixXd::Random(6, 6), K = random + random.transpose();
  std::vector<double> stored;
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b)
      for (int r = 0; r < 2; ++r)
        for (int s = 0; s < 2; ++s) stored.push_back(K(2 * a + r, 2 * b + s));
  std::vector<double> values(pattern.zero_matrix().value.size(), 0.0);
  blocks.add_stored(stored.data(), values.data());
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(6, 4);  // x at the corners
  G.topLeftCorner(2, 2) = G.block(2, 2, 2, 2) = G.block(4, 2, 2, 2) = Eigen::Matrix2d::Identity();
  const Eigen::MatrixXd expected = (G.transpose() * K * G).triangularView<Eigen::Lower>();
  CHECK((lower_part(pattern, values) - expected).norm() <= 1e-14);
}

TEST_CASE("a pattern without an element's pair of nodes is refused") {
  const Restriction restriction({0, 1, 2}, 3, 3);
  const assembly::HessianPattern pattern(assembly::FreeUnknowns(2, 3), assembly::PatternBuilder(3));
  CHECK_THROWS_WITH_AS(BlockAssembler(restriction, pattern), doctest::Contains("not coupled"), Error);
}

TEST_CASE("the Laplacian is the Dirichlet form of linear functions, and pinned nodes leave it") {
  for (const Elements& elements : {assembly::elements_from(mesh::elements(bar())),
                                   assembly::elements_from(mesh::elements(mesh::quadratic(bar())))}) {
    const auto u = random_numbers(static_cast<std::size_t>(elements.node_count), 5);
    double expected = 0;  // sum w |grad u|^2
    const std::size_t k = static_cast<std::size_t>(elements.nodes_per_element);
    for_every_point(elements, [&](std::size_t e, std::size_t point) {
      Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
      for (std::size_t a = 0; a < k; ++a)
        gradient += u[static_cast<std::size_t>(elements.nodes[e * k + a])] *
                    Eigen::Map<const Eigen::Vector3d>(elements.gradients.data() + (point * k + a) * 3);
      expected += elements.weights[point] * gradient.squaredNorm();
    });
    const sparse::SymmetricMatrix K = assembly::operators::laplacian(elements);
    K.validate();
    std::vector<double> Ku(u.size()), ones(u.size(), 1.0);
    K.multiply(u.data(), Ku.data());
    double form = 0;
    for (std::size_t i = 0; i < u.size(); ++i) form += u[i] * Ku[i];
    CHECK(form == doctest::Approx(expected).epsilon(1e-12));
    K.multiply(ones.data(), Ku.data());  // constants have no gradient
    for (const double entry : Ku) CHECK(std::abs(entry) < 1e-12 * K.value[0]);

    std::vector<bool> pinned(u.size(), false);
    pinned[0] = true;
    const sparse::SymmetricMatrix free =
        assembly::operators::laplacian(elements, assembly::FreeUnknowns(1, elements.node_count, pinned));
    REQUIRE(free.size == K.size - 1);
    const auto after_first = static_cast<std::ptrdiff_t>(K.column_start[1]);
    CHECK(free.value == std::vector<double>(K.value.begin() + after_first, K.value.end()));
  }
}

TEST_CASE("lumped masses are positive and add up to the volume") {
  const Elements elements = assembly::elements_from(mesh::elements(mesh::quadratic(bar())));
  double sum = 0;
  for (const double mass : assembly::operators::lumped_mass(elements)) {
    CHECK(mass > 0);
    sum += mass;
  }
  CHECK(sum == doctest::Approx(1.5));
}
