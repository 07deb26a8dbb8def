
#include <isostretch/figures/deformed_views.hpp>
#include <isostretch/figures/model_view.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace isostretch::figures {
namespace {

// A state where it is drawn: the vertices of the body, then the two ends of every marker.
struct PlacedState {
  mesh::Points3 vertices, marker_ends;
};

// All states with their markers in one unit ball, so that they stay comparable. Markers take part by
// triangles without an area.
std::vector<PlacedState> in_one_ball(const DeformationFigure& figure) {
  const Eigen::Index count = figure.states[0].vertices.rows();
  std::vector<Eigen::RowVector3d> points;
  std::vector<int> corners;
  for (const DeformedState& state : figure.states) {
    const int first = static_cast<int>(points.size());
    for (Eigen::Index v = 0; v < count; ++v) points.emplace_back(state.vertices.row(v));
    for (const int corner : figure.triangles.reshaped<Eigen::RowMajor>()) corners.push_back(first + corner);
    for (const Marker& marker : state.markers)
      for (const Eigen::RowVector3d& end : {marker.from, marker.to}) {
        corners.insert(corners.end(), 3, static_cast<int>(points.size()));
        points.push_back(end);
      }
  }
  mesh::Points3 all(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) all.row(static_cast<Eigen::Index>(i)) = points[i];
  const mesh::Points3 moved =
      in_unit_ball(all, Eigen::Map<const mesh::Triangles>(corners.data(), std::ssize(corners) / 3, 3));
  std::vector<PlacedState> result;
  Eigen::Index row = 0;
  for (const DeformedState& state : figure.states) {
    const Eigen::Index ends = 2 * std::ssize(state.markers);
    result.push_back({moved.middleRows(row, count), moved.middleRows(row + count, ends)});
    row += count + ends;
  }
  return result;
}

Box united(const Box& a, const Box& b) {
  const double x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
}

void draw_arrow(Canvas& canvas, Point from, Point to, Color color) {
  constexpr double head = 9, half_width = 4;
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  if (length < 2) return;
  const double ux = dx / length, uy = dy / length, reach = std::min(head, 0.6 * length);
  const Point neck{to.x - reach * ux, to.y - reach * uy};
  canvas.line(from, neck, {.color = color, .width = 2});
  canvas.polygon({to,
                  {neck.x - half_width * uy, neck.y + half_width * ux},
                  {neck.x + half_width * uy, neck.y - half_width * ux}},
                 color);
}

void draw_marker(Canvas& canvas, const Marker& marker, Point from, Point to, bool seen) {
  constexpr double ring = 4;
  switch (marker.kind) {
    case Marker::Kind::dot:
      if (seen || !marker.hollow_behind)
        canvas.dot(to, marker.radius, marker.color);
      else
        canvas.ring(to, marker.radius, {.color = marker.color, .width = 1, .opacity = 0.7});
      break;
    case Marker::Kind::arrow:
      draw_arrow(canvas, from, to, marker.color);
      break;
    case Marker::Kind::target:
      canvas.ring(to, ring, {.color = marker.color, .width = 1.5});
      if (std::hypot(to.x - from.x, to.y - from.y) > ring)
        canvas.line(from, to, {.color = marker.color, .width = 1.2});
      break;
  }
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

// One colour for all of a triangle, without any blend.
std::vector<Color> of_corners(const std::vector<Color>& of_triangles) {
  std::vector<Color> result;
  for (const Color& color : of_triangles) result.insert(result.end(), 3, color);
  return result;
}

std::vector<Color> colors(const DeformationFigure& figure, const DeformedState& state, const Corners& corners,
                          const DistortionScale& scale) {
  if (!state.triangle_colors.empty()) return of_corners(state.triangle_colors);
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

struct DeformedViews::Workspace {
  explicit Workspace(const DeformationFigure& f)
      : figure(f),
        states(in_one_ball(f)),
        corners(states[0].vertices, f.triangles),
        camera(camera_for(f, states[0].vertices)) {}

  const DeformationFigure& figure;
  std::vector<PlacedState> states;
  Corners corners;
  Camera camera;
  std::vector<Box> boxes = {};
};

DeformedViews::DeformedViews(const DeformationFigure& figure, int width, double most_height, double inset)
    : workspace_(std::make_unique<Workspace>(figure)), width_(width) {
  double w = 1e-12, h = 1e-12;
  for (const PlacedState& state : workspace_->states) {
    workspace_->boxes.push_back(bounds(workspace_->camera, state.vertices));
    if (state.marker_ends.rows() > 0)
      workspace_->boxes.back() =
          united(workspace_->boxes.back(), bounds(workspace_->camera, state.marker_ends));
    w = std::max(w, workspace_->boxes.back().width), h = std::max(h, workspace_->boxes.back().height);
  }
  scale_ = std::min((width - 2 * inset) / w, (most_height - 2 * inset) / h);
  height_ = scale_ * h + 2 * inset;
}

DeformedViews::~DeformedViews() = default;

void DeformedViews::draw(Canvas& canvas, std::size_t i, Point corner, int height,
                         const DistortionScale& scale) const {
  const Workspace& k = *workspace_;
  const DeformedState& state = k.figure.states[i];
  const mesh::Points3 vertices = k.corners.vertices(k.states[i].vertices),
                      normals = k.corners.normals(k.states[i].vertices);
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
  const mesh::Points3& ends = k.states[i].marker_ends;
  const ModelView view = draw_view(model, normals, k.camera, placement, width_, height, ends);
  canvas.image(view.picture, corner);
  const auto on_canvas = [&](Eigen::Index row) {
    const ScreenPoint p = k.camera(ends.row(row));
    return Point{corner.x + placement.shift.x + placement.scale * p.x,
                 corner.y + placement.shift.y + placement.scale * p.y};
  };
  for (std::size_t m = 0; m < state.markers.size(); ++m) {
    const auto row = static_cast<Eigen::Index>(2 * m);
    draw_marker(canvas, state.markers[m], on_canvas(row), on_canvas(row + 1), view.seen[2 * m]);
  }
}

}  // namespace isostretch::figures
