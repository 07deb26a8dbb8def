
#include <isostretch/figures/canvas.hpp>
#include <isostretch/figures/model_figure.hpp>
#include <isostretch/figures/model_view.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::figures {
namespace {

constexpr int width = 1600, least_height = 400, most_height = 900;
constexpr double margin = 24, top = 112, gap = 16, inset = 28;
constexpr int view_width = static_cast<int>((width - 2 * margin - gap) / 2);

// Pixels per unit of the screen, the same in both views so that both fit.
double common_scale(const Box& front, const Box& behind) {
  const double w = std::max({front.width, behind.width, 1e-12}),
               h = std::max({front.height, behind.height, 1e-12});
  return std::min((view_width - 2 * inset) / w, (most_height - top - margin - 2 * inset) / h);
}

int height_for(double model_height) {
  return std::clamp(static_cast<int>(std::ceil(model_height + top + margin + 2 * inset)), least_height,
                    most_height);
}

Placement centred(const Box& bounds, double scale, int view_height) {
  return {scale,
          {0.5 * view_width - scale * (bounds.x + 0.5 * bounds.width),
           0.5 * view_height - scale * (bounds.y + 0.5 * bounds.height)}};
}

void draw_titles(Canvas& canvas, const ModelFigure& figure) {
  const TextStyle title{.size = 32, .bold = true}, subtitle{.size = 23, .color = {0.3, 0.3, 0.3}};
  canvas.text({margin, 36}, canvas.shortened(figure.title, width - 2 * margin, title), title);
  canvas.text({margin, 76}, canvas.shortened(figure.subtitle, width - 2 * margin, subtitle), subtitle);
}

// Flipped triangles are often too small to be seen.
void draw(Canvas& canvas, const ModelView& view, Point corner, std::size_t flipped) {
  constexpr std::size_t few_flips = 200;
  canvas.image(view.picture, corner);
  if (flipped > few_flips) return;
  for (const Point& p : view.flipped) canvas.ring({corner.x + p.x, corner.y + p.y}, 6, {flipped_color, 2, 1});
}

}  // namespace

std::string draw_model(const ModelFigure& figure) {
  const ModelData& m = figure.model;
  const mesh::Points3 vertices = in_unit_ball(m.vertices, m.triangles);
  const mesh::Points3 normals = smooth_normals(vertices, m.triangles);
  const ModelData model{vertices, m.triangles, m.uv, m.uv_triangles, m.square, m.flipped, m.lines};
  const Pose pose = guess_pose(vertices, m.triangles);
  const Camera cameras[] = {{pose, 30, 18}, {pose, 210, 18}};
  const Box boxes[] = {bounds(cameras[0], vertices), bounds(cameras[1], vertices)};
  const double scale = common_scale(boxes[0], boxes[1]);
  const int height = height_for(scale * std::max(boxes[0].height, boxes[1].height));
  const int view_height = height - static_cast<int>(top + margin);

  Canvas canvas(width, height);
  draw_titles(canvas, figure);
  for (int i = 0; i < 2; ++i)
    draw(
        canvas,
        draw_view(model, normals, cameras[i], centred(boxes[i], scale, view_height), view_width, view_height),
        {margin + i * (view_width + gap), top}, model.flipped.size());
  return canvas.file();
}

}  // namespace isostretch::figures
