
#include <isostretch/figures/canvas.hpp>
#include <isostretch/figures/checkerboard.hpp>

#include <cmath>

namespace isostretch::figures {
namespace {

bool is_odd(double whole) {
  return whole - 2 * std::floor(whole / 2) == 1;
}

void draw_cell(Canvas& canvas, int column, int row, double size) {
  const bool dark = is_odd(column + row);
  const double left = column * size, top = (texture_cells - 1 - row) * size;
  canvas.fill({left, top, size, size}, dark ? checker_dark : checker_light);
  const Color faint = dark ? Color{0.81, 0.62, 0.53} : Color{0.83, 0.79, 0.71};
  canvas.text({left + 0.5 * size, top + 0.5 * size},
              std::string(1, static_cast<char>('A' + column)) + std::to_string(row + 1),
              {.size = 0.36 * size, .color = faint, .bold = true, .across = Align::middle});
}

}  // namespace

// Whole numbers are quicker than std::floor; beyond them there is nothing to be seen of squares.
Color checker_color(double u, double v) {
  constexpr double most = 1e15;
  if (!(std::abs(u) < most && std::abs(v) < most)) return checker_light;
  const auto below = [](double x) {
    return static_cast<long long>(x) - (x < static_cast<double>(static_cast<long long>(x)));
  };
  return ((below(u) + below(v)) & 1) != 0 ? checker_dark : checker_light;
}

std::string checker_texture() {
  constexpr int size = 1024;
  Canvas canvas(size, size);
  for (int row = 0; row < texture_cells; ++row)
    for (int column = 0; column < texture_cells; ++column)
      draw_cell(canvas, column, row, static_cast<double>(size) / texture_cells);
  return canvas.file();
}

}  // namespace isostretch::figures
