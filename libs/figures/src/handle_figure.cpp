
#include <isostretch/figures/deformed_views.hpp>
#include <isostretch/figures/handle_figure.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace isostretch::figures {
namespace {

constexpr int width = 1600, least_height = 480, most_height = 900;
constexpr double margin = 24, top = 118, gap = 24, inset = 28, legend_width = 400, entry_height = 62;

void draw_legend(Canvas& canvas, const std::vector<HandleLegend>& entries, double height) {
  const double x = width - margin - legend_width, room = height - top - margin;
  const auto most = static_cast<std::size_t>(std::max(2.0, std::floor(room / entry_height)));
  const std::size_t listed = entries.size() > most ? most - 1 : entries.size();
  double y = top + 0.25 * entry_height;
  const TextStyle name{.size = 21, .bold = true}, facts{.size = 18, .color = {0.3, 0.3, 0.3}};
  for (std::size_t i = 0; i < listed; ++i, y += entry_height) {
    canvas.dot({x + 10, y}, 9, handle_color(i));
    canvas.text({x + 30, y}, canvas.shortened(entries[i].name, legend_width - 30, name), name);
    canvas.text({x + 30, y + 26}, canvas.shortened(entries[i].facts, legend_width - 30, facts), facts);
  }
  if (listed < entries.size())
    canvas.text({x + 30, y}, "and " + std::to_string(entries.size() - listed) + " handles more", facts);
}

}  // namespace

Color handle_color(std::size_t handle) {
  // Okabe and Ito 2008, without black and with yellow darker.
  constexpr std::array<Color, 7> colors{{{0.84, 0.37, 0.00},
                                         {0.00, 0.45, 0.70},
                                         {0.00, 0.62, 0.45},
                                         {0.80, 0.47, 0.65},
                                         {0.90, 0.62, 0.00},
                                         {0.34, 0.71, 0.91},
                                         {0.72, 0.68, 0.10}}};
  return colors[handle % colors.size()];
}

std::string draw_handles(const HandleFigure& figure) {
  const int view_width = static_cast<int>(width - 2 * margin - gap - legend_width);
  const double around = top + margin;
  const DeformedViews views(figure.body, view_width, most_height - around, inset);
  const int height =
      std::clamp(static_cast<int>(std::ceil(views.height() + around)), least_height, most_height);
  Canvas canvas(width, height);
  const TextStyle title{.size = 32, .bold = true}, subtitle{.size = 22, .color = {0.3, 0.3, 0.3}};
  canvas.text({margin, 38}, canvas.shortened(figure.body.title, width - 2 * margin, title), title);
  canvas.text({margin, 82}, canvas.shortened(figure.body.subtitle, width - 2 * margin, subtitle), subtitle);
  views.draw(canvas, 0, {margin, top}, height - static_cast<int>(around), {});
  draw_legend(canvas, figure.legend, height);
  return canvas.file();
}

}  // namespace isostretch::figures
