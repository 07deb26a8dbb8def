#include "five_tets.hpp"
#include "generator_checks.hpp"

#include <isostretch/mesh/generators.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <vector>

namespace isostretch::mesh {
namespace {

using Vector3 = Eigen::Vector3d;

// Ellipsoids and upright legs, blended. Inside the animal the shape is negative.
class Animal {
 public:
  double operator()(const Vector3& p) const {
    double sum = 0;
    for (const Ellipsoid& e : ellipsoids_) sum += weight(e.radii.minCoeff() * (scaled(p, e) - 1));
    for (const Vector3& foot : feet_) sum += weight(from_leg(p, foot));
    return -blend * std::log(sum);
  }

  // The point of the surface near p: Newton steps along the gradient.
  Vector3 on_surface(Vector3 p) const {
    for (int step = 0; step < 8; ++step) {
      const Vector3 g = gradient(p);
      p -= (*this)(p) / std::max(g.squaredNorm(), 0.1) * g;
    }
    return p;
  }

 private:
  struct Ellipsoid {
    Vector3 center, radii;
  };

  static constexpr double blend = 0.02, leg_radius = 0.075, leg_top = 0.4;

  // Far from a part its share is zero; far from all of them the shape must still be a number.
  static double weight(double distance) { return std::exp(-std::min(distance, 10.0) / blend); }
  static double scaled(const Vector3& p, const Ellipsoid& e) {
    return (p - e.center).cwiseQuotient(e.radii).norm();
  }
  static double from_leg(const Vector3& p, const Vector3& foot) {
    const Vector3 nearest(foot.x(), foot.y(), std::clamp(p.z(), foot.z(), leg_top));
    return (p - nearest).norm() - leg_radius;
  }

  Vector3 gradient(const Vector3& p) const {
    constexpr double step = 1e-5;
    Vector3 g;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3 d = step * Vector3::Unit(axis);
      g[axis] = ((*this)(p + d) - (*this)(p - d)) / (2 * step);
    }
    return g;
  }

  std::array<Ellipsoid, 3> ellipsoids_{{{{0.40, 0, 0.40}, {0.39, 0.21, 0.19}},      // body
                                        {{0.78, 0, 0.52}, {0.14, 0.13, 0.13}},      // head
                                        {{0.89, 0, 0.47}, {0.10, 0.115, 0.085}}}};  // snout
  std::array<Vector3, 4> feet_{
      {{0.20, 0.135, 0.08}, {0.20, -0.135, 0.08}, {0.59, 0.135, 0.08}, {0.59, -0.135, 0.08}}};
};

// Cells of a box, some of them kept.
class Cells {
 public:
  Cells(int nx, int ny, int nz)
      : nx_(nx), ny_(ny), nz_(nz), kept_(static_cast<std::size_t>(nx) * ny * nz, false) {}

  bool kept(const Place& c) const { return inside(c) && kept_[index(c)]; }
  void keep(const Place& c) { kept_[index(c)] = true; }

  template <class Visit>
  void for_each(const Visit& visit) const {
    for (int k = 0; k < nz_; ++k)
      for (int j = 0; j < ny_; ++j)
        for (int i = 0; i < nx_; ++i) visit(Place{i, j, k});
  }

  // Whether the boundary is a surface at the corner: cells kept around it hang together by faces, and so do
  // the others.
  bool manifold_at(const Place& corner) const {
    int around = 0;  // a bit for each of the eight
    for (int bit = 0; bit < 8; ++bit)
      if (kept(neighbour(corner, bit))) around |= 1 << bit;
    return connected(around) && connected(255 & ~around);
  }

  static Place neighbour(const Place& corner, int bit) {
    return {corner.i - (bit & 1), corner.j - (bit >> 1 & 1), corner.k - (bit >> 2 & 1)};
  }

  bool inside(const Place& c) const {
    return c.i >= 0 && c.j >= 0 && c.k >= 0 && c.i < nx_ && c.j < ny_ && c.k < nz_;
  }

 private:
  std::size_t index(const Place& c) const {
    return (static_cast<std::size_t>(c.k) * static_cast<std::size_t>(ny_) + static_cast<std::size_t>(c.j)) *
               static_cast<std::size_t>(nx_) +
           static_cast<std::size_t>(c.i);
  }

  static bool connected(int set) {
    int reached = set & -set;
    for (int step = 0; step < 8; ++step) {
      int next = reached;
      for (int bit = 0; bit < 8; ++bit)
        if (reached >> bit & 1)
          for (const int axis : {1, 2, 4}) next |= 1 << (bit ^ axis);
      reached = next & set;
    }
    return reached == set;
  }

  int nx_, ny_, nz_;
  std::vector<bool> kept_;
};

// Cells are added, those deepest inside first, until the boundary is a surface everywhere.
void make_manifold(Cells& cells, const std::function<double(const Place&)>& shape) {
  for (bool changed = true; changed;) {
    changed = false;
    cells.for_each([&](const Place& corner) {
      while (!cells.manifold_at(corner)) {
        Place best;
        double least = std::numeric_limits<double>::infinity();
        for (int bit = 0; bit < 8; ++bit) {
          const Place c = Cells::neighbour(corner, bit);
          if (!cells.inside(c) || cells.kept(c) || shape(c) >= least) continue;
          best = c;
          least = shape(c);
        }
        cells.keep(best);
        changed = true;
      }
    });
  }
}

// Moves vertices one after the other, never leaving a tetrahedron below the quality allowed.
class Fitting {
 public:
  Fitting(TetMesh& mesh, const std::vector<bool>& on_boundary, const Animal& animal)
      : mesh_(mesh), on_boundary_(on_boundary), animal_(animal) {
    const auto count = static_cast<std::size_t>(mesh.vertices.rows());
    tets_of_.resize(count);
    neighbours_.resize(count);
    for (int t = 0; t < mesh.tets.rows(); ++t)
      for (int c = 0; c < 4; ++c) {
        const auto v = static_cast<std::size_t>(mesh.tets(t, c));
        tets_of_[v].push_back(t);
        for (int d = 0; d < 4; ++d)
          if (d != c) neighbours_[v].push_back(mesh.tets(t, d));
      }
    for (std::vector<int>& list : neighbours_) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
  }

  void run() {
    constexpr int smoothing = 6, closing = 3;
    for (int sweep = 0; sweep < smoothing + closing; ++sweep)
      for (int v = 0; v < mesh_.vertices.rows(); ++v)
        if (!on_boundary(v))
          approach(v, middle_of_neighbours(v), true);
        else
          approach(v, animal_.on_surface(sweep < smoothing ? middle_of_neighbours(v) : at(v)), false);
  }

 private:
  static constexpr double least_quality = 0.15;

  bool on_boundary(int v) const { return on_boundary_[static_cast<std::size_t>(v)]; }
  Vector3 at(int v) const { return mesh_.vertices.row(v).transpose(); }

  // On the boundary, of the neighbours there.
  Vector3 middle_of_neighbours(int v) const {
    Vector3 sum = Vector3::Zero();
    int count = 0;
    for (const int other : neighbours_[static_cast<std::size_t>(v)]) {
      if (on_boundary(v) && !on_boundary(other)) continue;
      sum += at(other);
      ++count;
    }
    return sum / count;
  }

  double quality(int t) const {
    double squares = 0;
    for (int a = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b)
        squares += (at(mesh_.tets(t, b)) - at(mesh_.tets(t, a))).squaredNorm() / 6;
    const Vector3 o = at(mesh_.tets(t, 0)), a = at(mesh_.tets(t, 1)) - o, b = at(mesh_.tets(t, 2)) - o,
                  c = at(mesh_.tets(t, 3)) - o;
    return std::numbers::sqrt2 * a.cross(b).dot(c) / (squares * std::sqrt(squares));
  }

  double worst_around(int v) const {
    double worst = 1;
    for (const int t : tets_of_[static_cast<std::size_t>(v)]) worst = std::min(worst, quality(t));
    return worst;
  }

  // The whole way, or a half, a quarter, ... of it.
  void approach(int v, const Vector3& target, bool only_better) {
    const Vector3 from = at(v);
    const double before = worst_around(v);
    for (double share = 1; share > 0.05; share /= 2) {
      mesh_.vertices.row(v) = (from + share * (target - from)).transpose();
      const double after = worst_around(v);
      if (after > before || (!only_better && after >= least_quality)) return;
    }
    mesh_.vertices.row(v) = from.transpose();
  }

  TetMesh& mesh_;
  const std::vector<bool>& on_boundary_;
  const Animal& animal_;
  std::vector<std::vector<int>> tets_of_, neighbours_;
};

}  // namespace

TetMesh quadruped(int n) {
  require_count("n", n, 12);
  // Cells across are even in number: the animal's left is the mirror image of its right.
  const int half = (n + 3) / 4, nx = n + 2, ny = 2 * half, nz = (7 * n + 9) / 10;
  require_indexable(4.0 * nx * ny * nz);
  const auto corner = [&](const Place& p) -> Vector3 { return Vector3(p.i - 1, p.j - half, p.k) / n; };
  const Animal animal;
  const auto shape = [&](const Place& cell) { return animal(corner(cell) + Vector3::Constant(0.5 / n)); };
  Cells cells(nx, ny, nz);
  cells.for_each([&](const Place& cell) {
    if (shape(cell) < 0) cells.keep(cell);
  });
  make_manifold(cells, shape);
  std::map<std::array<int, 3>, int> numbers;
  std::vector<Place> corners;
  const auto number = [&](const Place& p) {
    const auto [entry, is_new] = numbers.emplace(std::array{p.k, p.j, p.i}, static_cast<int>(corners.size()));
    if (is_new) corners.push_back(p);
    return entry->second;
  };
  std::vector<std::array<int, 4>> tets;
  cells.for_each([&](const Place& cell) {
    if (cells.kept(cell)) append_five(tets, cell, number);
  });
  TetMesh mesh;
  mesh.tets = rows_of(tets);
  mesh.vertices.resize(static_cast<Eigen::Index>(corners.size()), 3);
  std::vector<bool> on_boundary(corners.size(), false);
  for (std::size_t v = 0; v < corners.size(); ++v) {
    mesh.vertices.row(static_cast<Eigen::Index>(v)) = corner(corners[v]).transpose();
    for (int bit = 0; bit < 8; ++bit)
      if (!cells.kept(Cells::neighbour(corners[v], bit))) on_boundary[v] = true;
  }
  Fitting(mesh, on_boundary, animal).run();
  return mesh;
}

}  // namespace isostretch::mesh
