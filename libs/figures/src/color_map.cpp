#include <isostretch/figures/color_map.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isostretch::figures {
namespace {

double mix(double from, double to, double t) {
  return from + (to - from) * t;
}

double gamma_encoded(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

double cube(double x) {
  return x * x * x;
}

Color from_oklab(double L, double a, double b) {
  const double l = cube(L + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(L - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(L - 0.0894841775 * a - 1.2914855480 * b);
  return {gamma_encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          gamma_encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          gamma_encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

Color distortion_color(double value) {
  const double t = std::clamp(value, 0.0, 1.0);
  const double lightness = mix(0.94, 0.27, t);
  // Most chroma where the lightness leaves most room for it.
  const double chroma = 0.055 + 0.125 * std::sin(std::numbers::pi * std::pow(t, 0.8));
  const double hue = mix(105, -65, t) * std::numbers::pi / 180;
  return from_oklab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
}

Color diverging_color(double value) {
  const double t = std::clamp(std::abs(value), 0.0, 1.0);
  const double chroma = 0.17 * std::sin(std::numbers::pi * std::pow(t, 0.6) * 0.75);
  const double hue = (value < 0 ? 250 : 40) * std::numbers::pi / 180;
  return from_oklab(mix(0.97, 0.38, t), chroma * std::cos(hue), chroma * std::sin(hue));
}

}  // namespace isostretch::figures
