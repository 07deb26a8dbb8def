
#include <isostretch/figures/checkerboard.hpp>
#include <isostretch/figures/model_view.hpp>
#include <isostretch/figures/visibility.hpp>

#include <Eigen/Geometry>

#include <algorithm>

namespace isostretch::figures {
namespace {

constexpr Color line_color{0.12, 0.12, 0.14};
constexpr double line_width = 1.8;  // pixels
constexpr double line_slack = 0.004;

std::vector<ScreenPoint> on_screen(const mesh::Points3& vertices, const Camera& camera,
                                   const Placement& placement) {
  std::vector<ScreenPoint> points;
  points.reserve(static_cast<std::size_t>(vertices.rows()));
  for (Eigen::Index v = 0; v < vertices.rows(); ++v) {
    const ScreenPoint p = camera(vertices.row(v));
    points.push_back({Raster::samples * (placement.scale * p.x + placement.shift.x),
                      Raster::samples * (placement.scale * p.y + placement.shift.y), p.nearness});
  }
  return points;
}

Visibility visibility(const ModelData& model, const std::vector<ScreenPoint>& points, const Raster& raster) {
  Visibility seen(raster.columns(), raster.rows());
  const auto point = [&](int v) -> const ScreenPoint& { return points[static_cast<std::size_t>(v)]; };
  for (int t = 0; t < model.triangles.rows(); ++t)
    seen.add_triangle(t, point(model.triangles(t, 0)), point(model.triangles(t, 1)),
                      point(model.triangles(t, 2)));
  for (const auto& [a, b] : model.lines)
    seen.add_line(point(a), point(b), Raster::samples * line_width, line_slack);
  return seen;
}

// Weights of a triangle's corners at a point of the screen, in perspective.
class Weights {
 public:
  Weights(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) : a_(a), b_(b), c_(c) {
    area_ = cross(a, b, c.x, c.y);
  }
  // y runs down, so triangles that face the viewer are negative.
  bool from_behind() const { return area_ > 0; }

  Eigen::RowVector3d operator()(double x, double y) const {
    Eigen::RowVector3d weights(cross(b_, c_, x, y) / area_ * a_.nearness,
                               cross(c_, a_, x, y) / area_ * b_.nearness,
                               cross(a_, b_, x, y) / area_ * c_.nearness);
    weights = weights.cwiseMax(0.0);  // slivers round
    return weights / std::max(weights.sum(), 1e-300);
  }

 private:
  static double cross(const ScreenPoint& p, const ScreenPoint& q, double x, double y) {
    return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
  }
  ScreenPoint a_, b_, c_;
  double area_ = 0;
};

Color mixed(const Color& a, const Color& b, double t) {
  return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b)};
}

Color times(const Color& color, double light) {
  return {std::min(color.r * light, 1.0), std::min(color.g * light, 1.0), std::min(color.b * light, 1.0)};
}

class Shader {
 public:
  Shader(const ModelData& model, const mesh::Points3& normals, const Camera& camera,
         const std::vector<ScreenPoint>& points)
      : model_(model),
        normals_(normals),
        camera_(camera),
        points_(points),
        flipped_(static_cast<std::size_t>(model.triangles.rows()), false) {
    for (const int t : model.flipped) flipped_[static_cast<std::size_t>(t)] = true;
    key_ = (-0.45 * camera.right() + 0.6 * camera.up() + 0.75 * camera.back()).normalized();
    fill_ = (0.85 * camera.right() + 0.1 * camera.up() + 0.5 * camera.back()).normalized();
  }

  // What all samples of a triangle have in common.
  struct Face {
    int triangle = -1;
    Weights weights{{}, {}, {}};
    bool flipped = false;
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 2> uv = Eigen::Matrix<double, 3, 2>::Zero();
  };

  Face face(int triangle) const {
    const auto corner = [&](int c) { return model_.triangles(triangle, c); };
    const auto point = [&](int c) { return points_[static_cast<std::size_t>(corner(c))]; };
    Face face;
    face.triangle = triangle;
    face.weights = {point(0), point(1), point(2)};
    face.flipped = flipped_[static_cast<std::size_t>(triangle)];
    for (int c = 0; c < 3; ++c) {
      face.normals.row(c) = normals_.row(corner(c));
      if (model_.colors.empty())
        face.uv.row(c) = model_.uv.row(model_.uv_triangles(triangle, c)) / model_.square;
    }
    return face;
  }

  // Which changes little across a pixel.
  double brightness(const Face& face, double x, double y) const {
    return light(face, face.weights(x, y), face.weights.from_behind());
  }

  Color operator()(const Face& face, double x, double y, double brightness) const {
    // In the dark, too, and on the inside, flipped triangles are to be found.
    if (face.flipped) return times(flipped_color, std::max(brightness, 0.9));
    const Eigen::RowVector3d weights = face.weights(x, y);
    const Color color = model_.colors.empty() ? checker(face, weights) : mixed_color(face.triangle, weights);
    return times(face.weights.from_behind() ? mixed(color, {0.62, 0.63, 0.66}, 0.45) : color, brightness);
  }

 private:
  static Color checker(const Face& face, const Eigen::RowVector3d& weights) {
    const Eigen::RowVector2d uv = weights * face.uv;
    return checker_color(uv.x(), uv.y());
  }

  Color mixed_color(int triangle, const Eigen::RowVector3d& weights) const {
    Color sum;
    for (int c = 0; c < 3; ++c) {
      const Color& color = model_.colors[static_cast<std::size_t>(model_.triangles(triangle, c))];
      sum = {sum.r + weights[c] * color.r, sum.g + weights[c] * color.g, sum.b + weights[c] * color.b};
    }
    return sum;
  }

  double light(const Face& face, const Eigen::RowVector3d& weights, bool inside) const {
    Eigen::RowVector3d normal = weights * face.normals;
    if (inside) normal = -normal;
    const double length = normal.norm();
    if (length > 1e-12)
      normal /= length;
    else
      normal = camera_.back().transpose();
    return 0.45 + 0.5 * std::max(normal.dot(key_), 0.0) + 0.2 * std::max(normal.dot(fill_), 0.0);
  }

  const ModelData& model_;
  const mesh::Points3& normals_;
  const Camera& camera_;
  const std::vector<ScreenPoint>& points_;
  std::vector<bool> flipped_;
  Eigen::RowVector3d key_, fill_;
};

void shade_row(Raster& picture, const Visibility& seen, const Shader& shader, int row) {
  Shader::Face face;
  double brightness = 1;
  for (int column = 0; column < picture.columns(); ++column) {
    const int triangle = seen.at(column, row);
    if (triangle == Visibility::nothing) continue;
    if (triangle == Visibility::line) {
      picture.set_sample(column, row, line_color);
      continue;
    }
    const double x = column + 0.5, y = row + 0.5;
    const bool other = triangle != face.triangle;
    if (other) face = shader.face(triangle);
    if (other || column % Raster::samples == 0) brightness = shader.brightness(face, x, y);
    picture.set_sample(column, row, shader(face, x, y, brightness));
  }
}

void shade(Raster& picture, const Visibility& seen, const Shader& shader) {
#pragma omp parallel for schedule(dynamic, 32)
  for (int row = 0; row < picture.rows(); ++row) shade_row(picture, seen, shader, row);
}

std::vector<Point> seen_flips(const ModelData& model, const std::vector<ScreenPoint>& points,
                              const Visibility& seen) {
  std::vector<Point> flips;
  for (const int t : model.flipped) {
    ScreenPoint middle;
    for (int c = 0; c < 3; ++c) {
      const ScreenPoint& p = points[static_cast<std::size_t>(model.triangles(t, c))];
      middle = {middle.x + p.x / 3, middle.y + p.y / 3, middle.nearness + p.nearness / 3};
    }
    if (seen.sees(middle, line_slack))
      flips.push_back({middle.x / Raster::samples, middle.y / Raster::samples});
  }
  return flips;
}

}  // namespace

ModelView draw_view(const ModelData& model, const mesh::Points3& normals, const Camera& camera,
                    const Placement& placement, int width, int height, const mesh::Points3& probes) {
  ModelView view{Raster(width, height, view_ground), {}, {}};
  const std::vector<ScreenPoint> points = on_screen(model.vertices, camera, placement);
  const Visibility seen = visibility(model, points, view.picture);
  shade(view.picture, seen, Shader(model, normals, camera, points));
  view.flipped = seen_flips(model, points, seen);
  for (const ScreenPoint& probe : on_screen(probes, camera, placement))
    view.seen.push_back(seen.sees(probe, line_slack));
  return view;
}

}  // namespace isostretch::figures
