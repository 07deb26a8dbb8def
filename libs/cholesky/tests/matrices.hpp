#pragma once

// Small matrices, made as dense ones.
#include <isostretch/cholesky/analysis.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace isostretch::cholesky::test {

struct Matrix {
  int size = 0;
  std::vector<int> start{0}, row;
  std::vector<double> value;

  Pattern pattern() const { return {size, start.data(), row.data()}; }

  Eigen::MatrixXd dense() const {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
    for (int j = 0; j < size; ++j)
      for (int k = start[j]; k < start[j + 1]; ++k) A(row[k], j) = A(j, row[k]) = value[k];
    return A;
  }
};

inline Matrix lower(const Eigen::MatrixXd& A) {
  Matrix result;
  result.size = static_cast<int>(A.rows());
  for (int j = 0; j < result.size; ++j) {
    for (int i = j; i < result.size; ++i)
      if (i == j || A(i, j) != 0) {
        result.row.push_back(i);
        result.value.push_back(A(i, j));
      }
    result.start.push_back(static_cast<int>(result.row.size()));
  }
  return result;
}

// Random pattern with so many entries a column, diagonally dominant.
inline Matrix random_matrix(int size, double density, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1), chance(0, 1);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
  for (int j = 0; j < size; ++j)
    for (int i = j + 1; i < size; ++i)
      if (chance(generator) < density) A(i, j) = A(j, i) = uniform(generator);
  for (int j = 0; j < size; ++j) A(j, j) = A.col(j).cwiseAbs().sum() + 0.1;
  return lower(A);
}

// The Laplacian of a grid with so many unknowns a node.
inline Matrix grid(int width, int height, int block) {
  const int n = width * height * block;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  const auto couple = [&](int a, int b) {
    for (int r = 0; r < block; ++r)
      for (int c = 0; c < block; ++c) {
        const double w = r == c ? 1.0 : 0.2;
        A(a * block + r, a * block + c) += w;
        A(b * block + r, b * block + c) += w;
        A(a * block + r, b * block + c) -= w;
        A(b * block + c, a * block + r) -= w;
      }
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (x + 1 < width) couple(y * width + x, y * width + x + 1);
      if (y + 1 < height) couple(y * width + x, (y + 1) * width + x);
    }
  A.diagonal().array() += 0.01;
  return lower(A);
}

// So many matrices side by side that have nothing to do with each other.
inline Matrix repeated(const Matrix& one, int times) {
  Matrix result;
  for (int k = 0; k < times; ++k) {
    for (const int row : one.row) result.row.push_back(result.size + row);
    result.value.insert(result.value.end(), one.value.begin(), one.value.end());
    const int entries = result.start.back();
    for (int j = 1; j <= one.size; ++j) result.start.push_back(entries + one.start[j]);
    result.size += one.size;
  }
  return result;
}

// One unknown, the last, that is coupled to all others, which are not to each other.
inline Matrix arrowhead(int size) {
  Matrix result;
  result.size = size;
  for (int j = 0; j < size; ++j) {
    result.row.push_back(j);
    result.value.push_back(j + 1 < size ? 2.0 : 2.0 * size);
    if (j + 1 < size) {
      result.row.push_back(size - 1);
      result.value.push_back(-1.0);
    }
    result.start.push_back(static_cast<int>(result.row.size()));
  }
  return result;
}

inline std::vector<int> shuffled(int size, unsigned seed) {
  std::vector<int> order(static_cast<std::size_t>(size));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  return order;
}

}  // namespace isostretch::cholesky::test
