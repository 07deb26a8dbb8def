#include "face_list.hpp"

#include "polygon.hpp"

#include <isostretch/core/log.hpp>

#include <array>

namespace isostretch::mesh {
namespace {

// Places in the polygon's list without those that name the vertex of the one before: as a triangle written
// with four corners does.
std::vector<int> distinct_corners(const int* corners, int count) {
  std::vector<int> places;
  for (int c = 0; c < count; ++c)
    if (corners[c] != corners[(c + count - 1) % count]) places.push_back(c);
  return places;
}

// Triangles of one polygon, as places in its list; empty where it cannot be cut.
std::vector<int> cut(const int* corners, int count, const std::vector<double>& vertices) {
  const std::vector<int> places = distinct_corners(corners, count);
  if (places.size() <= 3) return places.size() == 3 ? places : std::vector<int>();
  std::vector<std::array<double, 3>> points;
  for (const int place : places) {
    const double* p = vertices.data() + 3 * static_cast<std::size_t>(corners[place]);
    points.push_back({p[0], p[1], p[2]});
  }
  std::vector<int> triangles = triangulated(points);
  for (int& corner : triangles) corner = places[static_cast<std::size_t>(corner)];
  return triangles;
}

}  // namespace

std::string FaceList::fault(std::size_t corners) const {
  return corners >= 3 || leave_out_ ? std::string()
                                    : "face with " + std::to_string(corners) + " vertices" + advice_;
}

void FaceList::add(const std::vector<int>& corners, const std::vector<int>& uv, const Place& place) {
  if (corners.size() < 3) {
    if (const std::string refused = fault(corners.size()); !refused.empty()) place.fail(refused);
    ++left_out_;
    return;
  }
  if (!empty() && has_uv() == uv.empty())
    place.fail(std::string("face ") + (uv.empty() ? "without" : "with") +
               " texture coordinates, unlike the faces before: give all faces some, or ignore them all");
  if (corners.size() > 3) positions_.push_back(place.position);
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  uv_.insert(uv_.end(), uv.begin(), uv.end());
  starts_.push_back(static_cast<int>(corners_.size()));
}

void FaceList::keep(const std::vector<char>& keep) {
  FaceList kept({.leave_out_faces = leave_out_, .face_advice = advice_});
  std::size_t polygon = 0;
  for (std::size_t f = 0; f < count(); ++f) {
    const bool is_polygon = size(f) > 3;
    if (keep[f]) {
      const auto from = static_cast<std::ptrdiff_t>(starts_[f]),
                 to = static_cast<std::ptrdiff_t>(starts_[f + 1]);
      kept.corners_.insert(kept.corners_.end(), corners_.begin() + from, corners_.begin() + to);
      if (has_uv()) kept.uv_.insert(kept.uv_.end(), uv_.begin() + from, uv_.begin() + to);
      kept.starts_.push_back(static_cast<int>(kept.corners_.size()));
      if (is_polygon) kept.positions_.push_back(positions_[polygon]);
    }
    polygon += is_polygon ? 1 : 0;
  }
  kept.left_out_ = left_out_;
  *this = std::move(kept);
}

SurfaceMesh FaceList::surface(const std::vector<double>& vertices, const std::vector<double>& uv,
                              const Place& file, CornerMap* origin) const {
  std::vector<int> triangles, uv_triangles;
  triangles.reserve(corners_.size());
  static const std::vector<int> whole = {0, 1, 2};
  std::size_t polygon = 0;
  long uncut = 0;
  for (std::size_t f = 0; f < count(); ++f) {
    const bool is_polygon = size(f) > 3;
    const std::vector<int> places = is_polygon ? cut(corners(f), size(f), vertices) : whole;
    if (places.empty()) {
      if (!leave_out_)
        Place{file.contents, file.name, positions_[polygon], file.by_byte}.fail(
            "face " + std::to_string(f) + " of " + std::to_string(size(f)) +
            " vertices crosses itself or has no area: it cannot be cut into triangles" + advice_);
      ++uncut;
    }
    polygon += is_polygon ? 1 : 0;
    for (const int place : places) {
      const auto corner = static_cast<std::size_t>(starts_[f] + place);
      triangles.push_back(corners_[corner]);
      if (has_uv()) uv_triangles.push_back(uv_[corner]);
    }
    if (!origin) continue;
    origin->face.insert(origin->face.end(), places.size() / 3, static_cast<int>(f));
    origin->corner.insert(origin->corner.end(), places.begin(), places.end());
  }
  report_left_out(file, uncut);
  const long cut_ones = static_cast<long>(polygon) - uncut;
  if (cut_ones > 0 && !origin)
    log(LogLevel::info, file.name + ": " + std::to_string(cut_ones) +
                            " face(s) of more than three vertices cut into triangles");
  if (triangles.empty()) file.fail("no faces");
  SurfaceMesh mesh{to_rows<double, 3>(vertices), to_rows<int, 3>(triangles), {}, {}};
  if (has_uv()) mesh.uv = to_rows<double, 2>(uv), mesh.uv_triangles = to_rows<int, 3>(uv_triangles);
  return mesh;
}

void FaceList::report_left_out(const Place& file, long polygons) const {
  if (left_out_ > 0)
    log(LogLevel::info,
        file.name + ": " + std::to_string(left_out_) + " face(s) of less than three vertices left out");
  if (polygons > 0)
    log(LogLevel::info, file.name + ": " + std::to_string(polygons) +
                            " face(s) that cross themselves or have no area left out");
}

}  // namespace isostretch::mesh
