#include "common/figures/deformed_views.hpp"

#include "common/figures/model_view.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace isostretch::app::figures {
namespace {

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

Camera camera_for(const DeformationFigure& figure, const mesh::Points3& rest) {
  if (figure.flat) return {Pose{Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()}, 0, 0};
  if (figure.up < 0) return {guess_pose(rest, figure.triangles), 30, 18};
  // z towards the viewer where it is not up, as in guess_pose().
  const Eigen::Vector3d up = Eigen::Vector3d::Unit(figure.up);
  return {Pose{up, figure.up == 2 ? Eigen::Vector3d(-Eigen::Vector3d::UnitY()) : Eigen::Vector3d::UnitZ()},
          30, 18};
}

}  // namespace

struct DeformedViews::Kept {
  explicit Kept(const DeformationFigure& f)
      : figure(f),
        vertices(in_one_ball(f)),
        corners(vertices[0], f.triangles),
        camera(camera_for(f, vertices[0])) {}

  const DeformationFigure& figure;
  std::vector<mesh::Points3> vertices;
  Corners corners;
  Camera camera;
  std::vector<Box> boxes = {};
};

DeformedViews::DeformedViews(const DeformationFigure& figure, int width, double most_height, double inset)
    : kept_(std::make_unique<Kept>(figure)), width_(width) {
  double w = 1e-12, h = 1e-12;
  for (const mesh::Points3& v : kept_->vertices) {
    kept_->boxes.push_back(bounds(kept_->camera, v));
    w = std::max(w, kept_->boxes.back().width), h = std::max(h, kept_->boxes.back().height);
  }
  scale_ = std::min((width - 2 * inset) / w, (most_height - 2 * inset) / h);
  height_ = scale_ * h + 2 * inset;
}

DeformedViews::~DeformedViews() = default;

void DeformedViews::draw(Canvas& canvas, std::size_t i, Point corner, int height,
                         const DistortionScale& scale) const {
  const Kept& k = *kept_;
  const DeformedState& state = k.figure.states[i];
  const mesh::Points3 vertices = k.corners.vertices(k.vertices[i]),
                      normals = k.corners.normals(k.vertices[i]);
  const mesh::Points2 no_uv;
  const mesh::Triangles no_uv_triangles;
  const std::vector<int> flipped = inverted_triangles(k.figure, state);
  const ModelData model{vertices,
                        k.corners.triangles(),
                        no_uv,
                        no_uv_triangles,
                        1,
                        flipped,
                        k.corners.lines(k.figure.lines),
                        colors(k.figure, state, k.corners, scale)};
  const Box& box = k.boxes[i];
  const Placement placement{scale_,
                            {0.5 * width_ - scale_ * (box.x + 0.5 * box.width),
                             0.5 * height - scale_ * (box.y + 0.5 * box.height)}};
  canvas.image(draw_view(model, normals, k.camera, placement, width_, height).picture, corner);
}

}  // namespace isostretch::app::figures
