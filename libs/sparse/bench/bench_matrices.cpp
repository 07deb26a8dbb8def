#include "bench_matrices.hpp"

#include <isostretch/core/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numeric>
#include <random>
#include <sstream>
#include <utility>
#include <vector>

namespace isostretch::sparse::bench {
namespace {

using Step = std::array<int, 3>;

// Nodes of a box and the steps along which they are coupled, each with its opposite.
struct Lattice {
  std::array<int, 3> nodes;
  std::vector<Step> steps;
  int unknowns;  // a node

  int count() const { return nodes[0] * nodes[1] * nodes[2]; }
  int number(const Step& at) const { return (at[0] * nodes[1] + at[1]) * nodes[2] + at[2]; }
  Step place(int number) const {
    return {number / (nodes[1] * nodes[2]), number / nodes[2] % nodes[1], number % nodes[2]};
  }
  bool contains(const Step& at) const {
    for (int axis = 0; axis < 3; ++axis)
      if (at[axis] < 0 || at[axis] >= nodes[axis]) return false;
    return true;
  }

  // Calls visit(neighbour, weight) for the neighbours of a node.
  template <class Visit>
  void for_each_neighbour(int node, const Visit& visit) const {
    const Step at = place(node);
    for (const Step& step : steps)
      for (const int sign : {-1, 1}) {
        const Step to{at[0] + sign * step[0], at[1] + sign * step[1], at[2] + sign * step[2]};
        if (contains(to)) visit(number(to), 1.0 / (step[0] + step[1] + step[2]));
      }
  }
};

std::vector<int> shuffled(int count) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  return order;
}

// Appends the columns of one node: w (u_i - u_j)^T B (u_i - u_j) for its edges, B = 1 on the diagonal and 0.3
// beside it, and a little of the identity, without which the whole body could move.
void append_columns(SymmetricMatrix& A, int node, int unknowns, double diagonal,
                    const std::vector<std::pair<int, double>>& later_neighbours) {
  constexpr double coupling = 0.3, shift = 1e-3;
  const auto append = [&](int row, double value) {
    A.row.push_back(row);
    A.value.push_back(value);
  };
  for (int a = 0; a < unknowns; ++a) {
    append(unknowns * node + a, diagonal + shift);
    for (int b = a + 1; b < unknowns; ++b) append(unknowns * node + b, coupling * diagonal);
    for (const auto& [neighbour, weight] : later_neighbours)
      for (int b = 0; b < unknowns; ++b)
        append(unknowns * neighbour + b, a == b ? -weight : -coupling * weight);
    A.column_start.push_back(A.nonzeros());
    A.group.push_back(node);
  }
}

SymmetricMatrix laplacian(const Lattice& lattice) {
  const std::vector<int> order = shuffled(lattice.count());
  std::vector<int> position(order.size());
  for (int p = 0; p < lattice.count(); ++p) position[static_cast<std::size_t>(order[p])] = p;
  SymmetricMatrix A;
  A.size = lattice.unknowns * lattice.count();
  A.column_start.push_back(0);
  std::vector<std::pair<int, double>> later;
  for (int p = 0; p < lattice.count(); ++p) {
    later.clear();
    double diagonal = 0;
    lattice.for_each_neighbour(order[p], [&](int neighbour, double weight) {
      diagonal += weight;
      if (position[neighbour] > p) later.emplace_back(position[neighbour], weight);
    });
    std::sort(later.begin(), later.end());
    append_columns(A, p, lattice.unknowns, diagonal, later);
  }
  return A;
}

}  // namespace

SymmetricMatrix grid_of_triangles(int triangles) {
  const int nodes = 1 + std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / 2.0))));
  return laplacian({{nodes, nodes, 1}, {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, 2});
}

SymmetricMatrix cube_of_tetrahedra(int tetrahedra) {
  const int nodes = 1 + std::max(1, static_cast<int>(std::lround(std::cbrt(tetrahedra / 6.0))));
  return laplacian({{nodes, nodes, nodes},
                    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
                    3});
}

SymmetricMatrix read_matrix_market(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw Error(path + ": cannot be opened");
  std::string line;
  if (!std::getline(file, line) || line.rfind("%%MatrixMarket matrix coordinate real symmetric", 0) != 0)
    throw Error(path + ": not a symmetric matrix of real numbers in coordinates");
  while (std::getline(file, line) && !line.empty() && line[0] == '%') {
  }
  int rows = 0, columns = 0;
  long entries = 0;
  std::istringstream(line) >> rows >> columns >> entries;
  if (rows < 1 || rows != columns || entries < 0) throw Error(path + ": not a square matrix");
  std::vector<Eigen::Triplet<double>> triplets;
  for (int j = 0; j < columns; ++j) triplets.emplace_back(j, j, 0.0);  // the diagonal is always there
  int i = 0, j = 0;
  double value = 0;
  while (entries-- > 0 && file >> i >> j >> value) {
    if (std::min(i, j) < 1 || std::max(i, j) > rows) throw Error(path + ": an entry is outside the matrix");
    triplets.emplace_back(std::max(i, j) - 1, std::min(i, j) - 1, value);
  }
  if (entries >= 0) throw Error(path + ": entries are missing");
  Eigen::SparseMatrix<double> lower(rows, columns);
  lower.setFromTriplets(triplets.begin(), triplets.end());
  return lower_triangle(lower);
}

}  // namespace isostretch::sparse::bench
