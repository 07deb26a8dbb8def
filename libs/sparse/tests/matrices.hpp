#pragma once

// Matrices for tests and benchmarks: Laplacians of structured meshes with dim x dim blocks, as an assembly
// makes them.
#include <isostretch/sparse/matrix.hpp>

#include <Eigen/SparseCore>

#include <random>
#include <vector>

namespace isostretch::sparse::test {

using Triplets = std::vector<Eigen::Triplet<double>>;

inline SymmetricMatrix from_triplets(int size, const Triplets& triplets) {
  Eigen::SparseMatrix<double> full(size, size);
  full.setFromTriplets(triplets.begin(), triplets.end());
  return lower_triangle(full);
}

// Adds w (u_i - u_j)^T B (u_i - u_j) with B = I + coupling of the coordinates, positive definite.
inline void add_edge(Triplets& triplets, int i, int j, int dim, double w) {
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b) {
      const double v = w * (a == b ? 1.0 : 0.3);
      triplets.emplace_back(dim * i + a, dim * i + b, v);
      triplets.emplace_back(dim * j + a, dim * j + b, v);
      triplets.emplace_back(dim * i + a, dim * j + b, -v);
      triplets.emplace_back(dim * j + a, dim * i + b, -v);
    }
}

inline SymmetricMatrix finish(int nodes, int dim, double shift, Triplets& triplets) {
  for (int i = 0; i < dim * nodes; ++i) triplets.emplace_back(i, i, shift);
  SymmetricMatrix A = from_triplets(dim * nodes, triplets);
  for (int i = 0; i < dim * nodes; ++i) A.group.push_back(i / dim);
  return A;
}

// Triangulated n x n grid, about 7 blocks a row.
inline SymmetricMatrix grid_2d(int n, double shift = 1e-3) {
  Triplets triplets;
  const auto node = [n](int i, int j) { return i * n + j; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (i + 1 < n) add_edge(triplets, node(i, j), node(i + 1, j), 2, 1.0 + 0.1 * (i % 3));
      if (j + 1 < n) add_edge(triplets, node(i, j), node(i, j + 1), 2, 1.0 + 0.1 * (j % 5));
      if (i + 1 < n && j + 1 < n) add_edge(triplets, node(i, j), node(i + 1, j + 1), 2, 0.5);
    }
  return finish(n * n, 2, shift, triplets);
}

// n x n x n grid with every cube cut into six tetrahedra, about 15 blocks a row.
inline SymmetricMatrix grid_3d(int n, double shift = 1e-3) {
  Triplets triplets;
  const auto node = [n](int i, int j, int k) { return (i * n + j) * n + k; };
  const int steps[7][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        for (const auto& s : steps)
          if (i + s[0] < n && j + s[1] < n && k + s[2] < n)
            add_edge(triplets, node(i, j, k), node(i + s[0], j + s[1], k + s[2]), 3,
                     1.0 / (s[0] + s[1] + s[2]));
  return finish(n * n * n, 3, shift, triplets);
}

inline SymmetricMatrix random_spd(int size, int entries_per_column, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> index(0, size - 1);
  std::uniform_real_distribution<double> weight(0.1, 1.0);
  Triplets triplets;
  for (int j = 0; j < size; ++j) {
    triplets.emplace_back(j, j, 0.5);
    for (int k = 0; k < entries_per_column; ++k) {
      const int i = index(random);
      const double w = weight(random);
      if (i == j) continue;
      triplets.emplace_back(i, i, w);
      triplets.emplace_back(j, j, w);
      triplets.emplace_back(i, j, 0.9 * w);
      triplets.emplace_back(j, i, 0.9 * w);
    }
  }
  return from_triplets(size, triplets);
}

inline double& diagonal_entry(SymmetricMatrix& A, int j) {
  return A.value[A.column_start[j]];
}

inline Eigen::VectorXd random_vector(int size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  Eigen::VectorXd x(size);
  for (int i = 0; i < size; ++i) x[i] = value(random);
  return x;
}

inline double relative_residual(const SymmetricMatrix& A, const Eigen::VectorXd& x,
                                const Eigen::VectorXd& b) {
  return (b - A.multiply(x)).norm() / b.norm();
}

}  // namespace isostretch::sparse::test
