
#include <isostretch/figures/convergence_plot.hpp>
#include <isostretch/figures/solve_figure.hpp>

#include <string>

namespace isostretch::figures {

std::string draw_solve(const SolveFigure& figure) {
  constexpr int width = 1600, height = 900;
  constexpr double margin = 24, top = 112;
  constexpr Box layout{margin, top, 840, height - top - margin};
  constexpr Box scale_box{884, top + 40, 172, height - top - margin - 80};
  constexpr Box convergence{1076, top, width - 1076 - margin, height - top - margin};

  Canvas canvas(width, height);
  const TextStyle title{.size = 32, .bold = true}, subtitle{.size = 23, .color = {0.3, 0.3, 0.3}};
  canvas.text({margin, 36}, canvas.shortened(figure.title, width - 2 * margin, title), title);
  canvas.text({margin, 76}, canvas.shortened(figure.subtitle, width - 2 * margin, subtitle), subtitle);

  const DistortionScale scale = distortion_scale(figure.layout.distortions, figure.areas, 56);
  draw_layout(canvas, layout, figure.layout, scale);
  canvas.text({scale_box.right(), scale_box.y - 38}, "|J|² + |J⁻¹|² (4: isometric)",
              {.size = 18, .across = Align::end});
  draw_distortion_scale(canvas, scale_box, scale);
  draw_convergence(canvas, convergence, figure.trace, figure.chart_of_row);
  return canvas.file();
}

}  // namespace isostretch::figures
