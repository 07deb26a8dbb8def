#include "common/figures/deformation_figure.hpp"

#include "common/figures/canvas.hpp"
#include "common/figures/distortion_scale.hpp"
#include "common/figures/layout_plot.hpp"
#include "common/figures/model_view.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace isostretch::app::figures {
namespace {

constexpr int width = 1600, least_height = 480, most_height = 900;
constexpr double margin = 24, top = 92, gap = 16, inset = 28, caption = 30, scale_width = 190;

// All states in one unit ball, so that they stay comparable.
std::vector<mesh::Points3> in_one_ball(const DeformationFigure& figure) {
  const Eigen::Index count = figure.states[0].vertices.rows();
  mesh::Points3 all(count * static_cast<Eigen::Index>(figure.states.size()), 3);
  mesh::Triangles triangles(figure.triangles.rows() * static_cast<Eigen::Index>(figure.states.size()), 3);
  for (std::size_t i = 0; i < figure.states.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    all.middleRows(at * count, count) = figure.states[i].vertices;
    triangles.middleRows(at * figure.triangles.rows(), figure.triangles.rows()) =
        figure.triangles.array() + static_cast<int>(at * count);
  }
  const mesh::Points3 moved = in_unit_ball(all, triangles);
  std::vector<mesh::Points3> result;
  for (std::size_t i = 0; i < figure.states.size(); ++i)
    result.emplace_back(moved.middleRows(static_cast<Eigen::Index>(i) * count, count));
  return result;
}

// Every triangle with corners of its own, so that a corner can have the normal of its side of a crease.
// Corner c of triangle t is vertex 3 t + c.
class Corners {
 public:
  Corners(const mesh::Points3& rest, const mesh::Triangles& triangles) : original_(triangles) {
    triangles_.resize(triangles.rows(), 3);
    for (Eigen::Index i = 0; i < triangles_.size(); ++i) triangles_.data()[i] = static_cast<int>(i);
    around_.resize(static_cast<std::size_t>(rest.rows()));
    for (int i = 0; i < original_.size(); ++i)
      around_[static_cast<std::size_t>(original_.data()[i])].push_back(i / 3);
    rest_normals_ = face_normals(rest);
  }

  const mesh::Triangles& triangles() const { return triangles_; }

  mesh::Points3 vertices(const mesh::Points3& points) const {
    mesh::Points3 result(triangles_.size(), 3);
    for (Eigen::Index i = 0; i < result.rows(); ++i) result.row(i) = points.row(original_.data()[i]);
    return result;
  }

  // Of the triangles around that are not beyond a crease of the rest shape.
  mesh::Points3 normals(const mesh::Points3& points) const {
    constexpr double crease = 0.7;  // cosine: 45 degrees
    const mesh::Points3 faces = face_normals(points);
    mesh::Points3 result = mesh::Points3::Zero(triangles_.size(), 3);
    for (Eigen::Index i = 0; i < result.rows(); ++i) {
      const Eigen::RowVector3d own = rest_normals_.row(i / 3).normalized();
      for (const int t : around_[static_cast<std::size_t>(original_.data()[i])])
        if (own.dot(rest_normals_.row(t).normalized()) > crease) result.row(i) += faces.row(t);
      if (result.row(i).norm() > 0) result.row(i).normalize();
    }
    return result;
  }

  // The mean around every vertex.
  std::vector<double> smoothed(const std::vector<double>& of_triangle) const {
    std::vector<double> result;
    for (const int vertex : original_.reshaped<Eigen::RowMajor>()) {
      const std::vector<int>& around = around_[static_cast<std::size_t>(vertex)];
      double sum = 0;
      for (const int t : around) sum += of_triangle[static_cast<std::size_t>(t)];
      result.push_back(sum / static_cast<double>(around.size()));
    }
    return result;
  }

  // Lines between vertices as lines between corners that lie there.
  std::vector<std::array<int, 2>> lines(const std::vector<std::array<int, 2>>& of_vertices) const {
    std::vector<int> corner(around_.size(), 0);
    for (int i = 0; i < original_.size(); ++i) corner[static_cast<std::size_t>(original_.data()[i])] = i;
    std::vector<std::array<int, 2>> result;
    for (const auto& [a, b] : of_vertices)
      result.push_back({corner[static_cast<std::size_t>(a)], corner[static_cast<std::size_t>(b)]});
    return result;
  }

 private:
  mesh::Points3 face_normals(const mesh::Points3& points) const {
    mesh::Points3 normals(original_.rows(), 3);
    for (Eigen::Index t = 0; t < normals.rows(); ++t) {
      const Eigen::RowVector3d p = points.row(original_(t, 0));
      normals.row(t) = (points.row(original_(t, 1)) - p).cross(points.row(original_(t, 2)) - p);
    }
    return normals;
  }

  const mesh::Triangles& original_;
  mesh::Triangles triangles_;
  std::vector<std::vector<int>> around_;  // triangles of every vertex
  mesh::Points3 rest_normals_;
};

std::vector<Color> colors(const DeformationFigure& figure, const DeformedState& state, const Corners& corners,
                          const DistortionScale& scale) {
  std::vector<double> of_triangle;
  for (const int e : figure.element) {
    const double value = scale.color_value(state.length_change[static_cast<std::size_t>(e)]);
    of_triangle.push_back(std::clamp(value, 0.0, 1.0));
  }
  std::vector<Color> result;
  for (const double value : corners.smoothed(of_triangle)) result.push_back(distortion_color(value));
  return result;
}

std::vector<int> inverted_triangles(const DeformationFigure& figure, const DeformedState& state) {
  std::vector<int> result;
  for (std::size_t t = 0; t < figure.element.size(); ++t)
    if (std::binary_search(state.inverted.begin(), state.inverted.end(), figure.element[t]))
      result.push_back(static_cast<int>(t));
  return result;
}

void draw_titles(Canvas& canvas, const DeformationFigure& figure) {
  const TextStyle title{.size = 20, .bold = true}, subtitle{.size = 14, .color = {0.3, 0.3, 0.3}};
  canvas.text({margin, 32}, canvas.shortened(figure.title, width - 2 * margin, title), title);
  canvas.text({margin, 60}, canvas.shortened(figure.subtitle, width - 2 * margin, subtitle), subtitle);
}

class Views {
 public:
  explicit Views(const DeformationFigure& figure)
      : figure_(figure),
        vertices_(in_one_ball(figure)),
        corners_(vertices_[0], figure.triangles),
        camera_(camera_for(figure, vertices_[0])) {
    const auto count = static_cast<double>(figure.states.size());
    view_width_ = static_cast<int>((width - 2 * margin - scale_width - gap * count) / count);
    double w = 1e-12, h = 1e-12;
    for (const mesh::Points3& v : vertices_) {
      boxes_.push_back(bounds(camera_, v));
      w = std::max(w, boxes_.back().width), h = std::max(h, boxes_.back().height);
    }
    scale_ = std::min((view_width_ - 2 * inset) / w, (most_height - top - margin - caption - 2 * inset) / h);
    height_ = std::clamp(static_cast<int>(std::ceil(scale_ * h + top + margin + caption + 2 * inset)),
                         least_height, most_height);
  }

  int height() const { return height_; }

  void draw(Canvas& canvas, const DistortionScale& scale) const {
    for (std::size_t i = 0; i < vertices_.size(); ++i) draw_state(canvas, i, scale);
  }

 private:
  static Camera camera_for(const DeformationFigure& figure, const mesh::Points3& rest) {
    if (figure.flat) return {Pose{Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()}, 0, 0};
    return {guess_pose(rest, figure.triangles), 30, 18};
  }

  void draw_state(Canvas& canvas, std::size_t i, const DistortionScale& scale) const {
    const DeformedState& state = figure_.states[i];
    const mesh::Points3 vertices = corners_.vertices(vertices_[i]), normals = corners_.normals(vertices_[i]);
    const mesh::Points2 no_uv;
    const mesh::Triangles no_uv_triangles;
    const std::vector<int> flipped = inverted_triangles(figure_, state);
    const ModelData model{vertices,
                          corners_.triangles(),
                          no_uv,
                          no_uv_triangles,
                          1,
                          flipped,
                          corners_.lines(figure_.lines),
                          colors(figure_, state, corners_, scale)};
    const int view_height = height_ - static_cast<int>(top + margin + caption);
    const Box& box = boxes_[i];
    const Placement placement{scale_,
                              {0.5 * view_width_ - scale_ * (box.x + 0.5 * box.width),
                               0.5 * view_height - scale_ * (box.y + 0.5 * box.height)}};
    const Point corner{margin + static_cast<double>(i) * (view_width_ + gap), top};
    canvas.image(draw_view(model, normals, camera_, placement, view_width_, view_height).picture, corner);
    canvas.text({corner.x + 0.5 * view_width_, height_ - margin - 0.4 * caption}, state.caption,
                {.size = 14, .color = {0.3, 0.3, 0.3}, .across = Align::middle});
  }

  const DeformationFigure& figure_;
  std::vector<mesh::Points3> vertices_;
  Corners corners_;
  Camera camera_;
  std::vector<Box> boxes_;
  int view_width_ = 0, height_ = 0;
  double scale_ = 1;
};

}  // namespace

std::string draw_deformation(const DeformationFigure& figure) {
  const Views views(figure);
  const DistortionScale scale = distortion_scale(figure.states.back().length_change, figure.volumes, 56, 1);
  Canvas canvas(width, views.height());
  draw_titles(canvas, figure);
  views.draw(canvas, scale);
  const Box box{width - margin - scale_width + 10, top + 40, scale_width - 10,
                views.height() - top - margin - 80};
  canvas.text({box.right(), box.y - 34}, "largest change of length", {.size = 12, .across = Align::end});
  draw_distortion_scale(canvas, box, scale, figure.flat ? "area" : "volume");
  return canvas.png();
}

}  // namespace isostretch::app::figures
