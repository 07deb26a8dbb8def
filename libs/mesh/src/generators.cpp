#include <isostretch/core/error.hpp>
#include <isostretch/mesh/generators.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace isostretch::mesh {
namespace {

constexpr double pi = std::numbers::pi;

void require_count(const char* what, int value, int least = 1) {
  if (value < least)
    throw Error(std::string(what) + " is " + std::to_string(value) + ", must be at least " +
                std::to_string(least));
}

void require_length(const char* what, double value) {
  if (!(value > 0 && std::isfinite(value)))
    throw Error(std::string(what) + " is " + std::to_string(value) + ", must be positive");
}

// Products of three counts below 2^31 each fit a double closely enough to tell.
void require_indexable(double elements) {
  if (6 * elements > std::numeric_limits<int>::max()) throw Error("the mesh asked for has too many elements");
}

SurfaceMesh subdivide(const SurfaceMesh& mesh) {
  std::map<std::pair<int, int>, int> middle;
  const auto V = static_cast<int>(mesh.vertices.rows());
  const auto F = static_cast<int>(mesh.triangles.rows());
  SurfaceMesh fine;
  fine.vertices.resize(V + 3 * F / 2, 3);
  fine.vertices.topRows(V) = mesh.vertices;
  fine.triangles.resize(4 * F, 3);
  const auto middle_of = [&](int a, int b) {
    const auto [entry, is_new] = middle.emplace(std::minmax(a, b), V + static_cast<int>(middle.size()));
    if (is_new)
      fine.vertices.row(entry->second) = (mesh.vertices.row(a) + mesh.vertices.row(b)).stableNormalized();
    return entry->second;
  };
  for (int t = 0; t < F; ++t) {
    const int a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2);
    const int ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
    fine.triangles.row(4 * t) << a, ab, ca;
    fine.triangles.row(4 * t + 1) << ab, b, bc;
    fine.triangles.row(4 * t + 2) << ca, bc, c;
    fine.triangles.row(4 * t + 3) << ab, bc, ca;
  }
  return fine;
}

SurfaceMesh icosahedron() {
  const double g = std::numbers::phi;
  SurfaceMesh mesh;
  mesh.vertices.resize(12, 3);
  mesh.vertices << -1, g, 0, 1, g, 0, -1, -g, 0, 1, -g, 0, 0, -1, g, 0, 1, g, 0, -1, -g, 0, 1, -g, g, 0, -1,
      g, 0, 1, -g, 0, -1, -g, 0, 1;
  for (auto row : mesh.vertices.rowwise()) row.normalize();
  mesh.triangles.resize(20, 3);
  mesh.triangles << 0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2, 10, 7, 6,
      7, 1, 8, 3, 9, 4, 3, 4, 2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9, 8, 1;
  return mesh;
}

// Vertices of ring k > 0 of a disc begin here; ring k has 6 k of them.
int ring_start(int k) {
  return k == 0 ? 0 : 1 + 3 * k * (k - 1);
}

int ring_vertex(int k, int i) {
  return k == 0 ? 0 : ring_start(k) + i % (6 * k);
}

// One of the six sectors between rings k and k + 1: k + 1 triangles standing on the outer ring, k on the
// inner.
void append_sector(Triangles& triangles, int& t, int k, int sector) {
  const int inner = sector * k, outer = sector * (k + 1);
  for (int i = 0; i <= k; ++i) {
    triangles.row(t++) << ring_vertex(k, inner + i), ring_vertex(k + 1, outer + i),
        ring_vertex(k + 1, outer + i + 1);
    if (i < k)
      triangles.row(t++) << ring_vertex(k, inner + i), ring_vertex(k + 1, outer + i + 1),
          ring_vertex(k, inner + i + 1);
  }
}

double bump(double x, double y, double cx, double cy, double wx, double wy) {
  const double dx = (x - cx) / wx, dy = (y - cy) / wy;
  return std::exp(-dx * dx - dy * dy);
}

// Radial displacement of the head; x to the right, y up, both in the unit disc.
double face_relief(double x, double y) {
  const double nose = 0.38 * bump(x, y, 0, -0.03, 0.07, 0.16);
  const double eyes = bump(x, y, -0.2, 0.17, 0.11, 0.07) + bump(x, y, 0.2, 0.17, 0.11, 0.07);
  const double mouth = 0.08 * bump(x, y, 0, -0.30, 0.16, 0.035) - 0.05 * bump(x, y, 0, -0.30, 0.14, 0.012);
  const double chin = 0.12 * bump(x, y, 0, -0.50, 0.15, 0.1);
  return nose - 0.12 * eyes + mouth + chin;
}

// A corner of a cell of a box of cells, or a cell by its lowest corner.
struct Place {
  int i = 0, j = 0, k = 0;
};

// The cell cut into five: one tetrahedron at each of the four corners whose coordinates have an even sum, one
// between these. Cells that share a face cut it alike.
template <class Number>
void append_five(std::vector<std::array<int, 4>>& tets, const Place& cell, const Number& number) {
  const bool odd = (cell.i + cell.j + cell.k) % 2 != 0;
  const auto corner = [&](int x, int y, int z) {
    return number(Place{cell.i + (odd ? 1 - x : x), cell.j + y, cell.k + z});
  };
  const auto append = [&](int a, int b, int c, int d) {
    if (odd) std::swap(c, d);  // the mirror image turned every tetrahedron over
    tets.push_back({a, b, c, d});
  };
  const int a = corner(1, 0, 0), b = corner(0, 1, 0), c = corner(0, 0, 1), d = corner(1, 1, 1);
  append(corner(0, 0, 0), a, b, c);
  append(corner(1, 1, 0), b, a, d);
  append(corner(1, 0, 1), a, c, d);
  append(corner(0, 1, 1), c, b, d);
  append(a, b, c, d);
}

Tets rows_of(const std::vector<std::array<int, 4>>& tets) {
  Tets rows(static_cast<Eigen::Index>(tets.size()), 4);
  for (std::size_t t = 0; t < tets.size(); ++t)
    rows.row(static_cast<Eigen::Index>(t)) << tets[t][0], tets[t][1], tets[t][2], tets[t][3];
  return rows;
}

// Which of the nested cubes with rounded edges the point of [-1, 1]^3 is on: half as wide as t, the radius of
// the edges is t (1 - t). They lead from spheres at the centre to the cube without kinks on the way, as the
// largest coordinate would have them, over which tetrahedra would be flat.
double rounded_level(const Eigen::Vector3d& point) {
  if (point.cwiseAbs().maxCoeff() >= 1) return 1;
  double low = 0, high = 1;
  for (int step = 0; step < 60; ++step) {
    const double t = 0.5 * (low + high);
    const Eigen::Vector3d beyond = (point.cwiseAbs().array() - t * t).max(0.0);
    (beyond.norm() > t - t * t ? low : high) = t;
  }
  return high;
}

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

SurfaceMesh grid(int nx, int ny, double width, double height) {
  require_count("nx", nx);
  require_count("ny", ny);
  require_length("width", width);
  require_length("height", height);
  require_indexable(double(nx) * ny);
  SurfaceMesh mesh;
  mesh.vertices.resize((nx + 1) * (ny + 1), 3);
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) mesh.vertices.row(j * (nx + 1) + i) << width * i / nx, height * j / ny, 0;
  mesh.triangles.resize(2 * nx * ny, 3);
  for (int j = 0, t = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = j * (nx + 1) + i, b = a + 1, c = b + nx + 1, d = a + nx + 1;
      mesh.triangles.row(t++) << a, b, c;
      mesh.triangles.row(t++) << a, c, d;
    }
  return mesh;
}

SurfaceMesh crossed_grid(int nx, int ny, double width, double height) {
  require_indexable(2.0 * nx * ny);
  const SurfaceMesh corners = grid(nx, ny, width, height);
  const auto first = static_cast<int>(corners.vertices.rows());
  SurfaceMesh mesh;
  mesh.vertices.resize(first + nx * ny, 3);
  mesh.vertices.topRows(first) = corners.vertices;
  mesh.triangles.resize(4 * nx * ny, 3);
  for (int j = 0, t = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = j * (nx + 1) + i, b = a + 1, c = b + nx + 1, d = a + nx + 1, m = first + j * nx + i;
      mesh.vertices.row(m) << width * (i + 0.5) / nx, height * (j + 0.5) / ny, 0;
      mesh.triangles.row(t++) << a, b, m;
      mesh.triangles.row(t++) << b, c, m;
      mesh.triangles.row(t++) << c, d, m;
      mesh.triangles.row(t++) << d, a, m;
    }
  return mesh;
}

SurfaceMesh disc(int rings) {
  require_count("rings", rings);
  require_indexable(6.0 * rings * rings);
  SurfaceMesh mesh;
  mesh.vertices.setZero(ring_start(rings + 1), 3);
  for (int k = 1; k <= rings; ++k)
    for (int i = 0; i < 6 * k; ++i) {
      const double radius = double(k) / rings, angle = 2 * pi * i / (6 * k);
      mesh.vertices.row(ring_vertex(k, i)) << radius * std::cos(angle), radius * std::sin(angle), 0;
    }
  mesh.triangles.resize(6 * rings * rings, 3);
  int t = 0;
  for (int k = 0; k < rings; ++k)
    for (int sector = 0; sector < 6; ++sector) append_sector(mesh.triangles, t, k, sector);
  return mesh;
}

SurfaceMesh icosphere(int level) {
  require_count("level", level, 0);
  require_indexable(20 * std::pow(4.0, level));
  SurfaceMesh mesh = icosahedron();
  for (int i = 0; i < level; ++i) mesh = subdivide(mesh);
  return mesh;
}

SurfaceMesh procedural_face(int rings) {
  SurfaceMesh mesh = disc(rings);
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    const double x = mesh.vertices(i, 0), y = mesh.vertices(i, 1), r = std::hypot(x, y);
    const double polar = 0.72 * pi * r;  // from the tip of the nose: the cap reaches behind the ears
    const double s = r > 0 ? std::sin(polar) / r : 0.72 * pi;
    const double radius = 1 + face_relief(x, y);
    mesh.vertices.row(i) << 0.8 * radius * s * x, 1.1 * radius * s * y, 0.9 * radius * std::cos(polar);
  }
  return mesh;
}

TetMesh tet_bar(int nx, int ny, int nz, double size_x, double size_y, double size_z) {
  const int n[3] = {nx, ny, nz};
  const double size[3] = {size_x, size_y, size_z};
  const char* count_name[3] = {"nx", "ny", "nz"};
  const char* size_name[3] = {"size_x", "size_y", "size_z"};
  for (int d = 0; d < 3; ++d) {
    require_count(count_name[d], n[d]);
    require_length(size_name[d], size[d]);
  }
  require_indexable(6.0 * nx * ny * nz);
  const auto vertex = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  TetMesh mesh;
  mesh.vertices.resize((nx + 1) * (ny + 1) * (nz + 1), 3);
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i)
        mesh.vertices.row(vertex(i, j, k)) << size_x * i / nx, size_y * j / ny, size_z * k / nz;
  // Kuhn's six: along every order of the axes from one corner of the box to the opposite one.
  const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  mesh.tets.resize(6 * nx * ny * nz, 4);
  int t = 0;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        for (int order = 0; order < 6; ++order) {
          int at[3] = {i, j, k}, corner[4] = {vertex(i, j, k), 0, 0, 0};
          for (int step = 0; step < 3; ++step) {
            ++at[orders[order][step]];
            corner[step + 1] = vertex(at[0], at[1], at[2]);
          }
          if (order >= 3) std::swap(corner[1], corner[2]);  // odd orders come out inverted
          mesh.tets.row(t++) << corner[0], corner[1], corner[2], corner[3];
        }
  return mesh;
}

TetMesh ball(int n) {
  require_count("n", n, 2);
  if (n % 2 != 0) throw Error("n is " + std::to_string(n) + ", must be even");
  require_indexable(4.0 * n * n * n);
  const auto number = [&](const Place& p) { return (p.i * (n + 1) + p.j) * (n + 1) + p.k; };
  TetMesh mesh;
  mesh.vertices.resize((n + 1) * (n + 1) * (n + 1), 3);
  std::vector<std::array<int, 4>> tets;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k) {
        const Vector3 p = Vector3(2 * i - n, 2 * j - n, 2 * k - n) / n;
        mesh.vertices.row(number({i, j, k})) = (rounded_level(p) * p.stableNormalized()).transpose();
        if (i < n && j < n && k < n) append_five(tets, {i, j, k}, number);
      }
  mesh.tets = rows_of(tets);
  return mesh;
}

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
