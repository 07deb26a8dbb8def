#pragma once

// Stiffness matrices of linear elasticity on a box of tetrahedra: what projected Newton makes in 3D, with
// pins, nearly incompressible materials and stretched elements to choose from.
#include "matrices.hpp"

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace isostretch::sparse::test {

struct ElasticBox {
  int cells[3] = {8, 8, 8};
  double size[3] = {1, 1, 1};  // of a cell: {1, 1, 0.05} makes flat elements
  double poisson = 0.3;
  double jitter = 0.2;       // nodes are moved by up to this share of a cell
  bool rollers = false;      // two thirds of the nodes with y = 0 slide: uneven groups
  double contrast = 0;       // stiffness 10^(contrast * u), u between 0 and 1, differs by element
  double negative_part = 0;  // added to every stiffness, so that < -1 makes the matrix indefinite
};

// So many cells along every axis.
inline ElasticBox box(int cells) {
  ElasticBox box;
  for (int& n : box.cells) n = cells;
  return box;
}

struct ElasticSystem {
  SymmetricMatrix A;           // group[i] is the node of unknown i; nodes with x = 0 are pinned
  std::vector<double> coords;  // x, y, z of every node, pinned ones too
  int nodes = 0;
  int tetrahedra = 0;
};

namespace elastic {

using Block = std::array<double, 9>;

// The seven edges from a node of a box whose cells are cut into six tetrahedra around their main diagonals,
// in the order of node numbers.
inline constexpr int steps[8][3] = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 1, 1},
                                    {1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1}};

struct Corners {
  int step[4];  // indices into steps, ascending
};

inline std::array<Corners, 6> tetrahedra() {
  const int axes[6][3] = {{1, 2, 4}, {1, 4, 2}, {2, 1, 4}, {2, 4, 1}, {4, 1, 2}, {4, 2, 1}};
  std::array<Corners, 6> all{};
  for (int t = 0; t < 6; ++t) {
    const int* a = axes[t];
    all[t] = {{0, a[0], a[0] + a[1], 7}};
  }
  return all;
}

// Gradients of the four shape functions; returns the volume.
inline double gradients(const double (&x)[4][3], double (&g)[4][3]) {
  double e[3][3], c[3][3];
  for (int i = 0; i < 3; ++i)
    for (int a = 0; a < 3; ++a) e[i][a] = x[i + 1][a] - x[0][a];
  for (int i = 0; i < 3; ++i) {
    const double *u = e[(i + 1) % 3], *v = e[(i + 2) % 3];
    for (int a = 0; a < 3; ++a) c[i][a] = u[(a + 1) % 3] * v[(a + 2) % 3] - u[(a + 2) % 3] * v[(a + 1) % 3];
  }
  const double det = e[0][0] * c[0][0] + e[0][1] * c[0][1] + e[0][2] * c[0][2];
  for (int a = 0; a < 3; ++a) {
    g[0][a] = 0;
    for (int i = 0; i < 3; ++i) {
      g[i + 1][a] = c[i][a] / det;
      g[0][a] -= g[i + 1][a];
    }
  }
  return std::abs(det) / 6;
}

}  // namespace elastic

inline ElasticSystem elastic_box(const ElasticBox& box, unsigned seed = 1) {
  using namespace elastic;
  const int n[3] = {box.cells[0] + 1, box.cells[1] + 1, box.cells[2] + 1};
  const auto node = [&](int i, int j, int k) { return (i * n[1] + j) * n[2] + k; };
  ElasticSystem system;
  system.nodes = n[0] * n[1] * n[2];
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < n[0]; ++i)
    for (int j = 0; j < n[1]; ++j)
      for (int k = 0; k < n[2]; ++k) {
        const int at[3] = {i, j, k};
        for (int a = 0; a < 3; ++a)
          system.coords.push_back(box.size[a] * (at[a] + box.jitter * 0.5 * unit(random)));
      }

  // block[8 * node + s] couples a node (column) with the one a step further (row).
  std::vector<Block> blocks(8 * static_cast<std::size_t>(system.nodes), Block{});
  const double mu = 1 / (2 * (1 + box.poisson));
  const double lambda = box.poisson / ((1 + box.poisson) * (1 - 2 * box.poisson));
  const auto tets = tetrahedra();
  for (int i = 0; i + 1 < n[0]; ++i)
    for (int j = 0; j + 1 < n[1]; ++j)
      for (int k = 0; k + 1 < n[2]; ++k)
        for (const Corners& tet : tets) {
          double x[4][3], g[4][3];
          int corner[4];
          for (int c = 0; c < 4; ++c) {
            const int* s = steps[tet.step[c]];
            corner[c] = node(i + s[0], j + s[1], k + s[2]);
            for (int a = 0; a < 3; ++a) x[c][a] = system.coords[3 * corner[c] + a];
          }
          double weight = gradients(x, g);
          if (box.contrast != 0) weight *= std::pow(10.0, box.contrast * 0.5 * (1 + unit(random)));
          if (box.negative_part != 0) weight *= 1 + box.negative_part * 0.5 * (1 + unit(random));
          ++system.tetrahedra;
          for (int p = 0; p < 4; ++p)
            for (int q = p; q < 4; ++q) {
              const int step = tet.step[q] - tet.step[p];
              Block& block = blocks[8 * static_cast<std::size_t>(corner[p]) + step];
              const double dot = g[p][0] * g[q][0] + g[p][1] * g[q][1] + g[p][2] * g[q][2];
              for (int a = 0; a < 3; ++a)    // component of q, the row
                for (int b = 0; b < 3; ++b)  // component of p, the column
                  block[3 * a + b] += weight * (lambda * g[q][a] * g[p][b] + mu * g[q][b] * g[p][a] +
                                                (a == b ? mu * dot : 0));
            }
        }

  SymmetricMatrix& A = system.A;
  std::vector<int> unknown(3 * static_cast<std::size_t>(system.nodes), -1);
  for (int v = 0; v < system.nodes; ++v)
    for (int a = 0; a < 3; ++a) {
      const bool pinned = v < n[1] * n[2];
      const bool slides = box.rollers && v / n[2] % n[1] == 0 && v % 3 != 0 && a == 1;
      if (pinned || slides) continue;
      unknown[3 * v + a] = A.size++;
      A.group.push_back(v);
    }
  A.column_start.push_back(0);
  for (int v = 0; v < system.nodes; ++v)
    for (int b = 0; b < 3; ++b) {
      const int column = unknown[3 * v + b];
      if (column < 0) continue;
      const int at[3] = {v / (n[1] * n[2]), v / n[2] % n[1], v % n[2]};
      for (int s = 0; s < 8; ++s) {
        const int to[3] = {at[0] + steps[s][0], at[1] + steps[s][1], at[2] + steps[s][2]};
        if (to[0] >= n[0] || to[1] >= n[1] || to[2] >= n[2]) continue;
        for (int a = 0; a < 3; ++a) {
          const int row = unknown[3 * node(to[0], to[1], to[2]) + a];
          if (row < column) continue;
          A.row.push_back(row);
          A.value.push_back(blocks[8 * static_cast<std::size_t>(v) + s][3 * a + b]);
        }
      }
      A.column_start.push_back(A.nonzeros());
    }
  return system;
}

}  // namespace isostretch::sparse::test
