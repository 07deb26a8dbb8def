#include <isostretch/figures/energy_maps.hpp>

#include <isostretch/core/text.hpp>
#include <isostretch/figures/axis.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace isostretch::figures {
namespace {

constexpr std::size_t lattice_points = 281;
constexpr int width = 1600, height = 870;
constexpr double side = 560;
constexpr Color dark{0.2, 0.2, 0.2}, outside{0.82, 0.82, 0.82};
constexpr LineStyle diagonal_style{dark, 1.2, 0.8, Dash::dashed}, volume_style{dark, 1.6, 0.8, Dash::dotted},
    zero_style{{0, 0, 0}, 2.2, 1}, seam_style{{1, 1, 1}, 4, 1}, level_style{{1, 1, 1}, 1, 0.75};

// What a colour bar is made of: 0 to 1 from its lower to its upper end.
struct Scale {
  std::function<double(double)> position;
  std::function<Color(double)> color;  // of a position
  std::vector<Tick> ticks;
};

std::vector<double> finite_values(const Lattice& field) {
  std::vector<double> values;
  for (const double value : field.values())
    if (std::isfinite(value)) values.push_back(value);
  std::sort(values.begin(), values.end());
  return values;
}

// The value that the given share of the field stays below.
double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0;
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

// Decades of psi above its least value.
Scale psi_scale(const std::vector<double>& sorted) {
  constexpr double decades = 1e-4, tiny = 1e-12;
  const double most = quantile(sorted, 0.995) - quantile(sorted, 0);
  const double high = most > tiny ? most : 1;
  const Axis axis = decade_axis(decades * high, high, 8);
  return {[axis](double value) { return value > axis.low ? axis.position(value) : 0; }, distortion_color,
          axis.ticks};
}

// Both signs, linear near zero and logarithmic beyond.
Scale eigenvalue_scale(const std::vector<double>& sorted) {
  constexpr double decades = 1e-3;
  const double most = std::max({std::abs(quantile(sorted, 0.005)), std::abs(quantile(sorted, 0.995)), 1e-12});
  const double near = decades * most;
  const auto position = [=](double value) {
    return 0.5 + std::copysign(0.5 * std::log1p(std::abs(value) / near) / std::log1p(most / near), value);
  };
  Scale scale{position, [](double t) { return diverging_color(2 * t - 1); }, {{0, "0"}}};
  for (double power = std::pow(10.0, std::floor(std::log10(most))); power > near; power /= 10)
    for (const double value : {power, -power}) scale.ticks.push_back({value, formatted("%.4g", value)});
  return scale;
}

// A map with its frame: places on the canvas, from shares of the sides.
struct Panel {
  Box box;
  const Lattice& field;
  inspection::StretchRange range;

  Point at(double x, double y) const { return {box.x + x * box.width, box.bottom() - y * box.height}; }
  double share(double stretch) const {
    return std::log(stretch / range.low) / std::log(range.high / range.low);
  }
};

// Colours vary too slowly for the samples inside of a pixel to differ.
void set_pixel(Raster& raster, int x, int y, Color color) {
  constexpr int samples = Raster::samples;
  for (int row = y * samples; row < (y + 1) * samples; ++row)
    for (int column = x * samples; column < (x + 1) * samples; ++column)
      raster.set_sample(column, row, color);
}

void draw_colors(Canvas& canvas, const Panel& panel, const Scale& scale) {
  Raster raster(static_cast<int>(panel.box.width), static_cast<int>(panel.box.height));
  for (int y = 0; y < raster.height(); ++y)
    for (int x = 0; x < raster.width(); ++x) {
      const double value = panel.field.between((x + 0.5) / raster.width(), 1 - (y + 0.5) / raster.height());
      set_pixel(raster, x, y,
                std::isfinite(value) ? scale.color(std::clamp(scale.position(value), 0.0, 1.0)) : outside);
    }
  canvas.image(raster, {panel.box.x, panel.box.y});
}

// Marching squares: a piece of line in every cell through which the level passes.
void draw_level(Canvas& canvas, const Panel& panel, const Lattice& field, double level,
                const LineStyle& style) {
  const double cells = static_cast<double>(field.points() - 1);
  for (std::size_t j = 0; j + 1 < field.points(); ++j)
    for (std::size_t i = 0; i + 1 < field.points(); ++i) {
      const std::array<std::array<std::size_t, 2>, 4> corners{
          {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
      std::vector<Point> crossings;
      for (std::size_t c = 0; c < 4; ++c) {
        const auto [x0, y0] = corners[c];
        const auto [x1, y1] = corners[(c + 1) % 4];
        const double a = field.at(x0, y0) - level, b = field.at(x1, y1) - level;
        if (!((a < 0) != (b < 0)) || !std::isfinite(a) || !std::isfinite(b)) continue;
        const double t = a / (a - b);
        crossings.push_back(panel.at(
            (static_cast<double>(x0) + t * (static_cast<double>(x1) - static_cast<double>(x0))) / cells,
            (static_cast<double>(y0) + t * (static_cast<double>(y1) - static_cast<double>(y0))) / cells));
      }
      for (std::size_t c = 0; c + 1 < crossings.size(); c += 2)
        canvas.line(crossings[c], crossings[c + 1], style);
    }
}

void draw_axes(Canvas& canvas, const Panel& panel) {
  const Box& box = panel.box;
  const Axis axis = narrow_log_axis(panel.range.low, panel.range.high, 8);
  for (const Tick& tick : axis.ticks) {
    const double t = axis.position(tick.value);
    const Point below = panel.at(t, 0), beside = panel.at(0, t);
    canvas.line(below, {below.x, below.y + 5}, {dark, 1, 1});
    canvas.line(beside, {beside.x - 5, beside.y}, {dark, 1, 1});
    canvas.text({below.x, below.y + 20}, tick.label, {.size = 18, .across = Align::middle});
    canvas.text({beside.x - 10, beside.y}, tick.label, {.size = 18, .across = Align::end});
  }
  canvas.frame(box, {dark, 1, 1});
  canvas.text({box.x + 0.5 * box.width, box.bottom() + 46}, "s₁", {.size = 20, .across = Align::middle});
  canvas.text({box.x - 60, box.y + 0.5 * box.height}, "s₂", {.size = 20, .across = Align::middle});
}

// With a light seam, to be seen on dark colours as well.
void draw_guide(Canvas& canvas, Point from, Point to, const LineStyle& style) {
  canvas.line(from, to, {{1, 1, 1}, style.width + 1.6, 0.45});
  canvas.line(from, to, style);
}

// The diagonal, s1 s2 = 1 and rest.
void draw_marks(Canvas& canvas, const Panel& panel) {
  draw_guide(canvas, panel.at(0, 0), panel.at(1, 1), diagonal_style);
  const double low = std::max(panel.range.low, 1 / panel.range.high), high = 1 / low;
  draw_guide(canvas, panel.at(panel.share(low), panel.share(high)),
             panel.at(panel.share(high), panel.share(low)), volume_style);
  const Point rest = panel.at(panel.share(1), panel.share(1));
  canvas.dot(rest, 4.5, {1, 1, 1});
  canvas.ring(rest, 4.5, {{0, 0, 0}, 1.5, 1});
}

void draw_scale(Canvas& canvas, const Box& box, const Scale& scale) {
  Raster raster(static_cast<int>(box.width), static_cast<int>(box.height));
  for (int y = 0; y < raster.height(); ++y)
    for (int x = 0; x < raster.width(); ++x)
      set_pixel(raster, x, y, scale.color(1 - (y + 0.5) / raster.height()));
  canvas.image(raster, {box.x, box.y});
  canvas.frame(box, {dark, 1, 1});
  for (const Tick& tick : scale.ticks) {
    const double at = box.bottom() - box.height * std::clamp(scale.position(tick.value), 0.0, 1.0);
    canvas.line({box.right(), at}, {box.right() + 5, at}, {dark, 1, 1});
    canvas.text({box.right() + 9, at}, tick.label, {.size = 18});
  }
}

void draw_panel(Canvas& canvas, const Panel& panel, const Lattice& eigenvalue, const Scale& scale,
                bool with_levels) {
  draw_colors(canvas, panel, scale);
  if (with_levels)
    for (const Tick& tick : scale.ticks) draw_level(canvas, panel, panel.field, tick.value, level_style);
  draw_level(canvas, panel, eigenvalue, 0, seam_style);
  draw_level(canvas, panel, eigenvalue, 0, zero_style);
  draw_marks(canvas, panel);
  draw_axes(canvas, panel);
  draw_scale(canvas, {panel.box.right() + 24, panel.box.y, 22, panel.box.height}, scale);
}

constexpr TextStyle legend_text{.size = 19};

void draw_legend(Canvas& canvas, Point at, bool outside_too) {
  const std::pair<LineStyle, const char*> lines[] = {
      {zero_style, "smallest eigenvalue 0"}, {diagonal_style, "s₁ = s₂"}, {volume_style, "s₁ s₂ = 1"}};
  for (const auto& [style, name] : lines) {
    canvas.line(at, {at.x + 36, at.y}, style);
    canvas.text({at.x + 44, at.y}, name, legend_text);
    at.x += 44 + canvas.text_width(name, legend_text) + 32;
  }
  canvas.ring({at.x + 5, at.y}, 4.5, {{0, 0, 0}, 1.5, 1});
  canvas.text({at.x + 17, at.y}, "rest", legend_text);
  if (!outside_too) return;
  canvas.fill({at.x + 80, at.y - 8, 16, 16}, outside);
  canvas.text({at.x + 104, at.y}, "outside of the domain", legend_text);
}

std::string title_of(const energies::AnyEnergy& energy) {
  std::string parameters;
  for (const auto& parameter : energy.parameters())
    parameters +=
        (parameters.empty() ? "   ·   " : ", ") + parameter.name + formatted(" = %.6g", parameter.value);
  return energy.name() + parameters;
}

}  // namespace

double Lattice::between(double x, double y) const {
  const double cells = static_cast<double>(points_ - 1);
  const auto cell = [&](double t) { return std::min(static_cast<std::size_t>(t * cells), points_ - 2); };
  const std::size_t i = cell(x), j = cell(y);
  const double u = x * cells - static_cast<double>(i), v = y * cells - static_cast<double>(j);
  return (1 - v) * ((1 - u) * at(i, j) + u * at(i + 1, j)) +
         v * ((1 - u) * at(i, j + 1) + u * at(i + 1, j + 1));
}

EnergyMaps::EnergyMaps(const energies::AnyEnergy& energy, int dim, const inspection::StretchRange& range)
    : title_(title_of(energy)), dim_(dim), range_(range), psi_(lattice_points), eigenvalue_(lattice_points) {
  const auto stretch = [&](std::size_t i) {
    return range.low * std::pow(range.high / range.low, static_cast<double>(i) / (lattice_points - 1));
  };
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < lattice_points; ++j) {
    std::vector<inspection::Stretches> row;
    for (std::size_t i = 0; i < lattice_points; ++i) row.push_back({stretch(i), stretch(j), 1});
    const std::vector<inspection::Spectrum> along = inspection::spectra(energy, dim, row);
    for (std::size_t i = 0; i < lattice_points; ++i) {
      const bool exists = along[i].in_domain();
      psi_.at(i, j) = exists ? along[i].psi : std::nan("");
      eigenvalue_.at(i, j) = exists ? along[i].least() : std::nan("");
      if (exists) least = std::min(least, along[i].psi);
    }
  }
  for (std::size_t j = 0; j < lattice_points; ++j)
    for (std::size_t i = 0; i < lattice_points; ++i) psi_.at(i, j) -= least;
}

std::string EnergyMaps::draw(PictureFormat format) const {
  constexpr double left = 100, top = 150, apart = 750;
  constexpr TextStyle heading{.size = 22, .bold = true};
  Canvas canvas(width, height, format);
  canvas.text({24, 38}, canvas.shortened(title_, width - 48, {.size = 29, .bold = true}),
              {.size = 29, .bold = true});
  canvas.text({24, 76}, dim_ == 2 ? "in the plane" : "in space, s₃ = 1",
              {.size = 20, .color = {0.35, 0.35, 0.35}});
  const std::vector<double> psi = finite_values(psi_), eigenvalues = finite_values(eigenvalue_);
  const Panel first{{left, top, side, side}, psi_, range_},
      second{{left + apart, top, side, side}, eigenvalue_, range_};
  canvas.text({first.box.x, top - 20}, "ψ above its least value", heading);
  canvas.text({second.box.x, top - 20}, "Smallest eigenvalue of the Hessian", heading);
  draw_panel(canvas, first, eigenvalue_, psi_scale(psi), true);
  draw_panel(canvas, second, eigenvalue_, eigenvalue_scale(eigenvalues), false);
  draw_legend(canvas, {left, height - 50}, psi.size() < psi_.values().size());
  return canvas.file();
}

}  // namespace isostretch::figures
