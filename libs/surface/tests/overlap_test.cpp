// Overlap of layouts: exact decisions, and areas against areas known otherwise.
#include <isostretch/core/error.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/surface/overlap.hpp>

#include <doctest/doctest.h>
#include <omp.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace isostretch;
using namespace isostretch::mesh;
using doctest::Approx;

namespace {

struct Layout {
  Points2 uv = Points2(0, 2);
  Triangles triangles = Triangles(0, 3);

  void add(std::array<std::array<double, 2>, 3> corners) {
    const Eigen::Index v = uv.rows(), t = triangles.rows();
    uv.conservativeResize(v + 3, 2);
    triangles.conservativeResize(t + 1, 3);
    for (Eigen::Index c = 0; c < 3; ++c) {
      const auto& corner = corners[static_cast<std::size_t>(c)];
      uv.row(v + c) << corner[0], corner[1];
      triangles(t, c) = static_cast<int>(v + c);
    }
  }
  // As two triangles, cut along either diagonal, turned over or not.
  void add_rectangle(double x, double y, double width, double height, bool other_diagonal = false,
                     bool turned = false) {
    std::array<double, 2> p[] = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    if (turned) std::swap(p[1], p[3]);
    if (other_diagonal) {
      add({p[0], p[1], p[3]});
      add({p[1], p[2], p[3]});
    } else {
      add({p[0], p[1], p[2]});
      add({p[0], p[2], p[3]});
    }
  }
  Overlap overlap() const { return find_overlap(uv, triangles); }
  std::size_t pairs() const { return overlapping_pairs(uv, triangles).size(); }
};

bool overlap(std::array<std::array<double, 2>, 3> a, std::array<std::array<double, 2>, 3> b) {
  Layout layout;
  layout.add(a);
  layout.add(b);
  const std::size_t pairs = layout.pairs();
  CHECK(layout.overlap().triangles.size() == 2 * pairs);
  return pairs == 1;
}

Points2 turned(const Points2& uv, double angle) {
  Eigen::Matrix2d turn;
  turn << std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle);
  return uv * turn;
}

double above(double x) {
  return std::nextafter(x, 2 * x + 1);
}

}  // namespace

TEST_CASE("overlap: triangles that lie beside each other do not, by edge, part of an edge or vertex") {
  for (const double angle : {0.0, 0.3, 1.0, 2.5}) {
    const SurfaceMesh flat = grid(12, 9), round = disc(9);
    for (const SurfaceMesh& mesh : {flat, round}) {
      const Overlap none = find_overlap(turned(mesh.vertices.leftCols(2), angle), mesh.triangles);
      CHECK(none.triangles.empty());
      CHECK(none.overlapped_area == 0);
      CHECK(none.covered_area == Approx(total_area(mesh)).epsilon(1e-13));
      CHECK(none.share() == 0);
    }
  }
  CHECK(!overlap({{{0, 0}, {2, 0}, {1, 2}}}, {{{0.5, 0}, {1, -1}, {1.5, 0}}}));  // on part of an edge
  CHECK(!overlap({{{0, 0}, {2, 0}, {1, 2}}}, {{{1, 0}, {3, 0}, {2, -1}}}));
  CHECK(!overlap({{{0, 0}, {2, 0}, {1, 2}}}, {{{1, 0}, {0, -1}, {2, -1}}}));  // a vertex on an edge
  CHECK(!overlap({{{0, 0}, {2, 0}, {1, 2}}}, {{{2, 0}, {3, 0}, {2, 1}}}));    // a vertex on a vertex
}

TEST_CASE("overlap: folded, turned over, contained and equal triangles do") {
  CHECK(overlap({{{0, 0}, {1, 0}, {0, 1}}}, {{{1, 0}, {0, 0}, {0.2, 0.1}}}));  // folded on the common edge
  CHECK(overlap({{{0, 0}, {1, 0}, {0, 1}}}, {{{0, 0}, {1, 0}, {0, 1}}}));
  CHECK(overlap({{{0, 0}, {1, 0}, {0, 1}}}, {{{0, 1}, {1, 0}, {0, 0}}}));
  CHECK(overlap({{{0, 0}, {9, 0}, {0, 9}}}, {{{1, 1}, {2, 1}, {1, 2}}}));
  CHECK(
      overlap({{{0, 0}, {2, 0}, {1, 2}}}, {{{0.5, 0}, {1, 1}, {1.5, 0}}}));  // along part of an edge, inside
  CHECK(overlap({{{0, 0}, {3, 0}, {1, 3}}}, {{{0, 2}, {3, 2}, {2, -1}}}));   // a star
}

TEST_CASE("overlap: triangles without area and empty layouts overlap nothing") {
  CHECK(!overlap({{{0, 0}, {4, 0}, {0, 4}}}, {{{1, 1}, {1, 1}, {1, 1}}}));
  CHECK(!overlap({{{0, 0}, {4, 0}, {0, 4}}}, {{{0, 0}, {1, 1}, {2, 2}}}));
  CHECK(find_overlap(Points2(0, 2), Triangles(0, 3)).covered_area == 0);
  CHECK(find_overlap(Points2::Zero(3, 2), Triangles::Zero(1, 3)).share() == 0);
}

TEST_CASE("overlap: one unit in the last place decides") {
  for (const double x : {1.0, 0.1, 1e-3, 12345.678}) {
    const double y = x * 0.7;
    CHECK(!overlap({{{0, 0}, {x, 0}, {x, y}}}, {{{x, 0}, {2 * x, 0}, {x, y}}}));
    CHECK(overlap({{{0, 0}, {above(x), 0}, {above(x), y}}}, {{{x, 0}, {2 * x, 0}, {x, y}}}));
  }
  // Near a line that passes no other number: doubles alone see points on the wrong side.
  const double tiny = std::numeric_limits<double>::epsilon() / 2;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j) {
      const double px = 0.5 + i * tiny, py = 0.5 + j * tiny;
      // The line is y = x; the first triangle lies below it, the other one has its lowest corner at (px, py).
      CHECK(overlap({{{12, 12}, {24, 0}, {24, 24}}}, {{{px, py}, {24, 25}, {0, 1}}}) == false);
      CHECK(overlap({{{0, 0}, {24, 0}, {24, 24}}}, {{{px, py}, {24, 25}, {0, 1}}}) == (py < px));
    }
}

TEST_CASE("overlap: areas of rectangles at random, against a grid that has all their sides") {
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> place(0, 12), size(1, 6), coin(0, 1);
  for (int round = 0; round < 60; ++round) {
    Layout layout;
    std::vector<std::array<int, 4>> rectangles;
    for (int i = 0; i < 3 + round; ++i) {
      const int x = place(generator), y = place(generator), w = size(generator), h = size(generator);
      rectangles.push_back({x, y, w, h});
      layout.add_rectangle(x, y, w, h, coin(generator) != 0, coin(generator) != 0);
    }
    int covered = 0, several = 0;
    for (int x = 0; x < 20; ++x)
      for (int y = 0; y < 20; ++y) {
        const auto depth = std::count_if(rectangles.begin(), rectangles.end(), [&](const auto& r) {
          return r[0] <= x && x < r[0] + r[2] && r[1] <= y && y < r[1] + r[3];
        });
        covered += depth > 0, several += depth > 1;
      }
    CHECK(layout.overlap().covered_area == Approx(covered).epsilon(1e-13));
    CHECK(layout.overlap().overlapped_area == Approx(several).epsilon(1e-13));
    // No angle and no scale changes them.
    Layout other = layout;
    other.uv = turned(layout.uv, 0.1 * round) * std::pow(10.0, round - 30);
    const double unit = std::pow(10.0, 2 * (round - 30));
    CHECK(other.overlap().covered_area == Approx(covered * unit).epsilon(1e-12));
    CHECK(other.overlap().overlapped_area == Approx(several * unit).epsilon(1e-11));
  }
}

TEST_CASE(
    "overlap: areas of hundreds of tiles that are almost equal, against a grid that has all their sides") {
  for (const double noise : {1e-9, 1e-3, 0.1}) {
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> shift(-noise, noise);
    constexpr std::size_t tiles = 300;
    Layout layout;
    std::array<std::vector<double>, 2> low, high, sides;
    for (std::size_t i = 0; i < tiles; ++i) {
      for (std::size_t d = 0; d < 2; ++d) {
        low[d].push_back(shift(generator));
        high[d].push_back(1 + shift(generator));
        sides[d].push_back(low[d].back());
        sides[d].push_back(high[d].back());
      }
      layout.add_rectangle(low[0][i], low[1][i], high[0][i] - low[0][i], high[1][i] - low[1][i], i % 2 == 0,
                           i % 3 == 0);
    }
    double covered = 0, several = 0;
    for (auto& axis : sides) std::sort(axis.begin(), axis.end());
    for (std::size_t x = 0; x + 1 < 2 * tiles; ++x)
      for (std::size_t y = 0; y + 1 < 2 * tiles; ++y) {
        const double area = (sides[0][x + 1] - sides[0][x]) * (sides[1][y + 1] - sides[1][y]);
        int depth = 0;
        for (std::size_t i = 0; i < tiles && depth < 2; ++i)
          depth += low[0][i] <= sides[0][x] && sides[0][x + 1] <= high[0][i] && low[1][i] <= sides[1][y] &&
                   sides[1][y + 1] <= high[1][i];
        covered += depth > 0 ? area : 0;
        several += depth > 1 ? area : 0;
      }
    const Overlap overlap = layout.overlap();
    CHECK(overlap.triangles.size() == 2 * tiles);
    CHECK(overlap.covered_area == Approx(covered).epsilon(1e-12));
    CHECK(overlap.overlapped_area == Approx(several).epsilon(1e-12));
  }
}

TEST_CASE("overlap: copies of a triangle take no memory for every pair") {
  Layout layout;
  layout.add_rectangle(0, 0, 1, 1);
  const Triangles once = layout.triangles;
  constexpr int copies = 100000;
  layout.triangles = once.replicate(copies, 1);
  const Overlap all = layout.overlap();
  CHECK(all.triangles.size() == 2 * copies);
  CHECK(all.covered_area == Approx(1));
  CHECK(all.overlapped_area == Approx(1));
  layout.triangles = once.replicate(30, 1);
  CHECK(layout.pairs() == 2 * 30 * 29 / 2);
}

TEST_CASE("overlap: the smallest and the largest coordinates") {
  for (const double unit : {1e-300, 1e-150, 1e-20, 1e20, 1e150, 1e300}) {
    Layout layout;
    layout.add_rectangle(0, 0, unit, unit);
    layout.add_rectangle(0.5 * unit, 0.25 * unit, unit, unit);
    CHECK(layout.pairs() == 3);
    CHECK(layout.overlap().triangles.size() == 4);
    if (unit > 1e-160 && unit < 1e150)
      CHECK(layout.overlap().share() == Approx(0.375 / 1.625));  // an area has bounds
  }
}

TEST_CASE("overlap: the same on one thread and on several, to the bit") {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> number(0, 1);
  const SurfaceMesh mesh = grid(60, 60);
  Points2 uv = mesh.vertices.leftCols(2);
  for (Eigen::Index i = 0; i < uv.size(); ++i) uv.data()[i] += 0.02 * number(generator);
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const Overlap one = find_overlap(uv, mesh.triangles);
  const auto pairs = overlapping_pairs(uv, mesh.triangles);
  omp_set_num_threads(4);
  const Overlap four = find_overlap(uv, mesh.triangles);
  CHECK(pairs == overlapping_pairs(uv, mesh.triangles));
  omp_set_num_threads(before);
  CHECK(!one.triangles.empty());
  CHECK(one.triangles == four.triangles);
  CHECK(one.covered_area == four.covered_area);
  CHECK(one.overlapped_area == four.overlapped_area);
}

TEST_CASE("overlap: errors name what is wrong") {
  Layout layout;
  layout.add({{{0, 0}, {1, 0}, {0, 1}}});
  Layout nan = layout, index = layout;
  nan.uv(1, 0) = std::nan("");
  index.triangles(0, 2) = 3;
  CHECK_THROWS_WITH_AS(nan.overlap(), doctest::Contains("point 1"), Error);
  CHECK_THROWS_WITH_AS(index.overlap(), doctest::Contains("triangle 0"), Error);
}
