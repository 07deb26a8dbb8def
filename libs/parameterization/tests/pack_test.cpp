// Packing charts into the unit square.
#include <isostretch/core/error.hpp>
#include <isostretch/parameterization/pack.hpp>
#include <isostretch/surface/orientation.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace isostretch;
using namespace isostretch::parameterization;

namespace {

struct Atlas {
  std::vector<mesh::Points2> charts;
  std::vector<mesh::Triangles> triangles;
};

// A rectangle of two triangles, turned by an angle.
void add_rectangle(Atlas& atlas, double width, double height, double angle) {
  mesh::Points2 points(4, 2);
  points << 0, 0, width, 0, width, height, 0, height;
  const double c = std::cos(angle), s = std::sin(angle);
  for (Eigen::Index i = 0; i < 4; ++i) {
    const double x = points(i, 0), y = points(i, 1);
    points.row(i) << c * x - s * y + 7, s * x + c * y - 3;
  }
  mesh::Triangles triangles(2, 3);
  triangles << 0, 1, 2, 0, 2, 3;
  atlas.charts.push_back(points);
  atlas.triangles.push_back(triangles);
}

struct Box {
  double low[2], high[2];
};

Box box_of(const mesh::Points2& points) {
  return {{points.col(0).minCoeff(), points.col(1).minCoeff()},
          {points.col(0).maxCoeff(), points.col(1).maxCoeff()}};
}

// In the square, and apart from each other, by the margin.
void check_apart(const Atlas& atlas, double margin) {
  const double slack = 1e-12;
  for (std::size_t i = 0; i < atlas.charts.size(); ++i) {
    const Box a = box_of(atlas.charts[i]);
    for (int d = 0; d < 2; ++d) {
      CHECK(a.low[d] >= margin - slack);
      CHECK(a.high[d] <= 1 - margin + slack);
    }
    for (std::size_t j = 0; j < i; ++j) {
      const Box b = box_of(atlas.charts[j]);
      const bool apart = a.low[0] >= b.high[0] + margin - slack || b.low[0] >= a.high[0] + margin - slack ||
                         a.low[1] >= b.high[1] + margin - slack || b.low[1] >= a.high[1] + margin - slack;
      CHECK(apart);
    }
  }
}

}  // namespace

TEST_CASE("charts come to lie in the unit square with margins, at one scale, unflipped") {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> size(0.05, 2.0), angle(0, 6.28);
  for (const int count : {1, 2, 7, 60, 300}) {
    CAPTURE(count);
    Atlas atlas;
    std::vector<double> areas;
    double total = 0;
    for (int i = 0; i < count; ++i) {
      add_rectangle(atlas, size(generator), size(generator), angle(generator));
      areas.push_back(mesh::orientation(atlas.charts.back(), atlas.triangles.back()).total_area);
      total += areas.back();
    }
    const double margin = 1.0 / 256;
    const Packing packing = pack(atlas.charts, atlas.triangles, {.margin = margin});
    check_apart(atlas, margin);
    CHECK(packing.coverage == doctest::Approx(total * packing.scale * packing.scale).epsilon(1e-12));
    for (int i = 0; i < count; ++i) {
      const auto c = static_cast<std::size_t>(i);
      const double area = mesh::orientation(atlas.charts[c], atlas.triangles[c]).total_area;
      CHECK(area == doctest::Approx(areas[c] * packing.scale * packing.scale).epsilon(1e-12));
    }
    // Random rectangles pack well, also one that lies at an angle fills as much as its shape lets it.
    if (count > 5) CHECK(packing.coverage > 0.6);
  }
}

TEST_CASE("equal squares pack as a chessboard") {
  Atlas atlas;
  for (int i = 0; i < 64; ++i) add_rectangle(atlas, 1, 1, 0.1 * i);
  const Packing packing = pack(atlas.charts, atlas.triangles, {.margin = 0});
  CHECK(packing.coverage == doctest::Approx(1.0).epsilon(0.03));
}

TEST_CASE("faults are named") {
  Atlas atlas;
  add_rectangle(atlas, 1, 1, 0);
  add_rectangle(atlas, 1, 1, 0);
  atlas.charts[1](2, 0) = std::nan("");
  CHECK_THROWS_WITH_AS(pack(atlas.charts, atlas.triangles), "pack: chart 1 has a point that is not finite",
                       Error);
  atlas.charts[1].setZero();
  atlas.triangles[0].resize(0, 3);
  CHECK_THROWS_WITH_AS(pack(atlas.charts, atlas.triangles), "pack: chart 0 has no triangles", Error);
  Atlas many;
  for (int i = 0; i < 64; ++i) add_rectangle(many, 1, 1, 0);
  CHECK_THROWS_WITH_AS(pack(many.charts, many.triangles, {.margin = 0.2}),
                       doctest::Contains("leaves no room for 64 charts"), Error);
}
