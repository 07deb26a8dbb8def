#include <isostretch/core/numbers.hpp>
#include "common/output_folder.hpp"
#include "scratch.hpp"

#include <isostretch/core/to_text.hpp>
#include <isostretch/figures/axis.hpp>
#include <isostretch/figures/canvas.hpp>
#include <isostretch/figures/comparison_plot.hpp>
#include <isostretch/figures/distortion_scale.hpp>
#include <isostretch/figures/raster.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

using namespace isostretch::app;
using namespace isostretch::figures;
using doctest::Approx;
using isostretch::test::Scratch;

TEST_CASE("numbers are taken whole or not at all") {
  CHECK(isostretch::finite_number("-1.5e3") == -1500);
  CHECK(isostretch::finite_number("+2") == 2);
  for (const char* text : {"", "1x", " 1", "nan", "inf", "1e400", "+-1", "0x10", "1,5"})
    CHECK_MESSAGE(!isostretch::finite_number(text), text);
  CHECK(isostretch::whole_number("12") == 12);
  for (const char* text : {"", "1.0", "99999999999", "1e3"})
    CHECK_MESSAGE(!isostretch::whole_number(text), text);
  CHECK(isostretch::split("a,,b", ',') == std::vector<std::string>{"a", "", "b"});
  CHECK(std::stod(isostretch::to_text(0.1 + 0.2)) == 0.1 + 0.2);
}

TEST_CASE("axes have a few round ticks inside their range") {
  const Axis axes[] = {linear_axis(27, 6, true),    linear_axis(0.003, 5),      linear_axis(0, 5),
                       linear_axis(1, 6, true),     decade_axis(1e-16, 1e9, 9), decade_axis(3, 3, 9),
                       narrow_log_axis(4, 4.04, 8), narrow_log_axis(4, 30, 8),  narrow_log_axis(4, 4e8, 8)};
  for (const Axis& axis : axes) {
    CHECK(axis.ticks.size() >= 2);
    int labels = 0;
    for (const Tick& tick : axis.ticks) {
      CHECK(axis.position(tick.value) >= -1e-9);
      CHECK(axis.position(tick.value) <= 1 + 1e-9);
      labels += !tick.label.empty();
    }
    CHECK(labels >= 2);
    CHECK(labels <= 11);
  }
  CHECK(axes[0].ticks[0].label == "0");
}

TEST_CASE("the distortion scale shares out the whole area") {
  const double inf = std::numeric_limits<double>::infinity();
  const DistortionScale scale = distortion_scale({4, 4.5, 5, inf}, {1, 1, 1, 0.001}, 10);
  double sum = 0;
  for (const double share : scale.shares) sum += share;
  CHECK(sum == Approx(1));
  CHECK(scale.above);
  CHECK(scale.axis.high == 5);
  CHECK(distortion(1, 1) == 4);
  CHECK(distortion(2, 0) == inf);
}

TEST_CASE("triangles that share an edge leave no gap and cover nothing else") {
  Raster raster(8, 8, {0, 0, 0});
  raster.fill_triangle({1, 1, 7, 1, 7, 7}, {1, 1, 1});
  raster.fill_triangle({1, 1, 7, 7, 1, 7}, {1, 1, 1});
  raster.fill_triangle({-1e300, 0, std::nan(""), 1, 1e300, 2}, {1, 0, 0});
  raster.fill_triangle({20, 20, 30, 20, 20, 30}, {1, 0, 0});
  const auto pixels = raster.pixels();
  for (int y = 2; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      CHECK(pixels[static_cast<std::size_t>(8 * y + x)] == (x > 0 && x < 7 && y < 7 ? 0xFFFFFFU : 0U));
}

TEST_CASE("long titles are shortened between characters") {
  Canvas canvas(200, 50);
  const std::string text = canvas.shortened("äöüäöüäöüäöüäöüäöüäöüäöüäöü", 100);
  CHECK(text.find("…") != std::string::npos);
  CHECK(canvas.text_width(text) <= 100);
  CHECK(canvas.shortened("short", 100) == "short");
  CHECK(canvas.file().substr(1, 3) == "PNG");
}

TEST_CASE("comparisons are drawn as pixels and as shapes, whatever the numbers") {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  ComparisonPanel empty{"empty", "x", true, true, {{}, {}}};
  ComparisonPanel odd{"odd", "x", true, true, {{{0, 0}, {1, nan}, {2, inf}, {3, 1e-300}}, {{1, 1}}}};
  odd.lowest_y = 1e-13;
  odd.levels = {1e-4, 1e30};
  const std::vector<std::string> names{"one & <two>", ""};
  const auto draw = [&](PictureFormat format) {
    return draw_comparison("title", "subtitle", names, {empty, odd}, 2, format);
  };
  CHECK(draw(PictureFormat::png).substr(1, 3) == "PNG");
  const std::string svg = draw(PictureFormat::svg);
  CHECK(svg.find("<svg") != std::string::npos);
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf") == std::string::npos);
}

TEST_CASE("an output folder is filled at once or not at all") {
  const Scratch scratch;
  {
    OutputFolder folder(scratch.path("a/b"));
    folder.add("one", "text");
  }
  CHECK(scratch.contents().empty());
  OutputFolder folder(scratch.path("a/b/"));
  folder.add("one", "text");
  folder.add_json("two", {{"name", "\xff"}, {"number", 0.1}, {"nothing", std::nan("")}});
  folder.commit();
  CHECK(scratch.contents() == std::vector<std::string>{"a", "a/b", "a/b/one", "a/b/two"});
  CHECK(isostretch::test::read_file(scratch.path("a/b/one")) == "text");
  CHECK(isostretch::test::read_json(scratch.path("a/b/two"))["nothing"].is_null());
}
