
#include <isostretch/figures/deformation_figure.hpp>
#include <isostretch/figures/deformed_views.hpp>
#include <isostretch/figures/layout_plot.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::figures {
namespace {

constexpr int width = 1600, least_height = 480, most_height = 900;
constexpr double margin = 24, top = 118, gap = 16, inset = 28, caption = 42, scale_width = 230;

void draw_titles(Canvas& canvas, const DeformationFigure& figure) {
  const TextStyle title{.size = 32, .bold = true}, subtitle{.size = 22, .color = {0.3, 0.3, 0.3}};
  canvas.text({margin, 38}, canvas.shortened(figure.title, width - 2 * margin, title), title);
  canvas.text({margin, 82}, canvas.shortened(figure.subtitle, width - 2 * margin, subtitle), subtitle);
}

}  // namespace

std::string draw_deformation(const DeformationFigure& figure) {
  const auto count = static_cast<double>(figure.states.size());
  const int view_width = static_cast<int>((width - 2 * margin - scale_width - gap * count) / count);
  const double around = top + margin + caption;
  const DeformedViews views(figure, view_width, most_height - around, inset);
  const int height =
      std::clamp(static_cast<int>(std::ceil(views.height() + around)), least_height, most_height);
  const DistortionScale scale = distortion_scale(figure.states.back().length_change, figure.volumes, 56, 1);
  Canvas canvas(width, height);
  draw_titles(canvas, figure);
  for (std::size_t i = 0; i < figure.states.size(); ++i) {
    const Point corner{margin + static_cast<double>(i) * (view_width + gap), top};
    views.draw(canvas, i, corner, height - static_cast<int>(around), scale);
    canvas.text({corner.x + 0.5 * view_width, height - margin - 0.4 * caption},
                canvas.shortened(figure.states[i].caption, view_width, {.size = 22}),
                {.size = 22, .color = {0.3, 0.3, 0.3}, .across = Align::middle});
  }
  const Box box{width - margin - scale_width + 10, top + 40, scale_width - 10, height - top - margin - 80};
  canvas.text({box.right(), box.y - 38}, "change of length", {.size = 19, .across = Align::end});
  draw_distortion_scale(canvas, box, scale, figure.flat ? "area" : "volume");
  return canvas.file();
}

std::vector<std::string> draw_each(const DeformationFigure& figure) {
  constexpr int frame_width = 720, frame_height = 540;
  const DeformedViews views(figure, frame_width, frame_height, 12);
  const int height = std::clamp(static_cast<int>(std::ceil(views.height())), 120, frame_height);
  const DistortionScale scale = distortion_scale(figure.states.back().length_change, figure.volumes, 56, 1);
  std::vector<std::string> pictures;
  for (std::size_t i = 0; i < figure.states.size(); ++i) {
    Canvas canvas(frame_width, height);
    views.draw(canvas, i, {0, 0}, height, scale);
    pictures.push_back(canvas.file());
  }
  return pictures;
}

}  // namespace isostretch::figures
