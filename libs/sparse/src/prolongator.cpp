#include "prolongator.hpp"

#include "vector_operations.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace isostretch::sparse {
namespace {

constexpr int least_rows = 1024;

NearNullspace translations(const NodeSystem& system, int count) {
  const int b = system.matrix().height;
  NearNullspace modes{count, std::vector<double>(static_cast<std::size_t>(system.size()) * count, 0.0)};
  for (int slot = 0; slot < system.size(); ++slot)
    if (system.unknown_of(slot) >= 0) modes.mode[static_cast<std::size_t>(slot) * count + slot % b] = 1;
  return modes;
}

// Nodes with fewer unknowns than axes, where nobody says which they have, are left to the smoother.
void drop_incomplete_nodes(const NodeSystem& system, NearNullspace& modes) {
  if (system.axes_known()) return;
  const int b = system.matrix().height;
  for (int node = 0; node < system.matrix().rows; ++node)
    for (int r = 0; r < b; ++r)
      if (system.unknown_of(node * b + r) < 0) {
        const auto row = modes.mode.begin() + static_cast<std::ptrdiff_t>(node) * b * modes.count;
        std::fill(row, row + b * modes.count, 0.0);
      }
}

// Positions about their middle, in units of the extent, so that rotations are of the size of translations.
std::vector<double> centred_positions(const NodeSystem& system, const Coordinates& coordinates) {
  const int dim = coordinates.dim, nodes = system.matrix().rows;
  std::vector<double> position;
  position.reserve(static_cast<std::size_t>(dim) * nodes);
  for (int node = 0; node < nodes; ++node)
    for (int a = 0; a < dim; ++a)
      position.push_back(
          coordinates.position[static_cast<std::size_t>(dim) * system.group_of_node(node) + a]);
  std::vector<double> middle(dim, 0.0);
  for (std::size_t k = 0; k < position.size(); ++k) middle[k % dim] += position[k] / nodes;
  double extent = 0;
  for (std::size_t k = 0; k < position.size(); ++k) {
    position[k] -= middle[k % dim];
    extent = std::max(extent, std::abs(position[k]));
  }
  for (double& p : position) p /= extent > 0 ? extent : 1;
  return position;
}

void add_rotations(const NodeSystem& system, const Coordinates& coordinates, NearNullspace& modes) {
  const int dim = coordinates.dim;
  const std::vector<double> position = centred_positions(system, coordinates);
  for (int node = 0; node < system.matrix().rows; ++node) {
    const double* x = position.data() + static_cast<std::size_t>(dim) * node;
    int mode = dim;
    for (int a = 0; a < dim; ++a)
      for (int b = a + 1; b < dim; ++b, ++mode) {
        const auto entry = [&](int axis) -> double& {
          return modes.mode[static_cast<std::size_t>(dim * node + axis) * modes.count + mode];
        };
        if (system.unknown_of(dim * node + a) >= 0) entry(a) = -x[b];
        if (system.unknown_of(dim * node + b) >= 0) entry(b) = x[a];
      }
  }
}

// Nodes of each aggregate.
struct Members {
  std::vector<int> start, node;
};

Members members(const Aggregates& aggregates) {
  Members all{std::vector<int>(aggregates.count + 1, 0), {}};
  for (const int a : aggregates.of)
    if (a >= 0) ++all.start[a + 1];
  for (int a = 0; a < aggregates.count; ++a) all.start[a + 1] += all.start[a];
  all.node.resize(all.start.back());
  std::vector<int> next = all.start;
  for (std::size_t i = 0; i < aggregates.of.size(); ++i)
    if (aggregates.of[i] >= 0) all.node[next[aggregates.of[i]]++] = static_cast<int>(i);
  return all;
}

// The rows of T that belong to one aggregate, as a tall matrix with `count` columns.
class TallMatrix {
 public:
  TallMatrix(BlockCsr<double>& T, const int* begin, const int* end) : T_(T), begin_(begin), end_(end) {}

  double dot(int a, int b) const {
    double sum = 0;
    for_rows([&](const double* row) { sum += row[a] * row[b]; });
    return sum;
  }
  void subtract(int from, double factor, int what) {
    for_rows([&](double* row) { row[from] -= factor * row[what]; });
  }
  void scale(int column, double factor) {
    for_rows([&](double* row) { row[column] *= factor; });
  }

 private:
  template <class Visit>
  void for_rows(const Visit& visit) const {
    for (const int* node = begin_; node != end_; ++node)
      for (int r = 0; r < T_.height; ++r) visit(T_.block(T_.start[*node]) + r * T_.width);
  }

  BlockCsr<double>& T_;
  const int *begin_, *end_;
};

// Gram-Schmidt, every projection twice; R is count x count, upper.
void orthonormalize(TallMatrix Q, int count, double* R) {
  constexpr double dependent = 1e-6;
  for (int c = 0; c < count; ++c) {
    const double before = std::sqrt(Q.dot(c, c));
    for (int pass = 0; pass < 2; ++pass)
      for (int a = 0; a < c; ++a) {
        const double along = Q.dot(a, c);
        Q.subtract(c, along, a);
        R[a * count + c] += along;
      }
    const double after = std::sqrt(Q.dot(c, c));
    const bool keep = after > dependent * before;
    Q.scale(c, keep ? 1 / after : 0);
    R[c * count + c] = keep ? after : 0;
  }
}

// Power iterations. Slightly too small a value does no harm: omega 4/3 leaves room up to half as much again.
double largest_eigenvalue(const BlockCsr<double>& A, const std::vector<double>& inverse) {
  constexpr int iterations = 8;
  const int b = A.height;
  std::vector<double> v(static_cast<std::size_t>(b) * A.rows), w(v.size());
  std::uint32_t random = 1;
  for (double& entry : v)
    entry = static_cast<double>((random = random * 1664525u + 1013904223u) >> 8) - 8388608;
  double value = 0;
  for (int i = 0; i < iterations; ++i) {
    const double norm = std::sqrt(dot(v, v));
    if (!(norm > 0)) break;
    multiply(A, v.data(), w.data());
    for_ranges(A.rows, least_rows, [&](int begin, int end, int) {
      for (int node = begin; node < end; ++node)
        for (int r = 0; r < b; ++r) {
          double sum = 0;
          for (int c = 0; c < b; ++c)
            sum += inverse[(static_cast<std::size_t>(node) * b + r) * b + c] * w[node * b + c];
          v[node * b + r] = sum / norm;
        }
    });
    value = std::sqrt(dot(v, v));
  }
  return value;
}

}  // namespace

NearNullspace near_nullspace(const NodeSystem& system, const Coordinates& coordinates) {
  const int b = system.matrix().height, dim = coordinates.dim;
  const bool rotations = dim == b && dim > 1;
  NearNullspace modes = translations(system, rotations ? dim * (dim + 1) / 2 : b);
  if (rotations) add_rotations(system, coordinates, modes);
  drop_incomplete_nodes(system, modes);
  return modes;
}

BlockCsr<double> tentative_prolongator(const NearNullspace& modes, int height, const Aggregates& aggregates,
                                       NearNullspace& coarse) {
  const int count = modes.count;
  BlockCsr<double> T;
  T.rows = static_cast<int>(aggregates.of.size());
  T.columns = aggregates.count;
  T.height = height;
  T.width = count;
  for (int i = 0; i < T.rows; ++i) {
    if (aggregates.of[i] >= 0) {
      const auto row = modes.mode.begin() + static_cast<std::ptrdiff_t>(T.area()) * i;
      T.column.push_back(aggregates.of[i]);
      T.value.insert(T.value.end(), row, row + static_cast<std::ptrdiff_t>(T.area()));
    }
    T.start.push_back(static_cast<int>(T.column.size()));
  }
  const Members all = members(aggregates);
  const auto area = static_cast<std::size_t>(count) * count;
  coarse = {count, std::vector<double>(area * aggregates.count, 0.0)};
  for_ranges(aggregates.count, least_rows / 16, [&](int begin, int end, int) {
    for (int a = begin; a < end; ++a)
      orthonormalize({T, all.node.data() + all.start[a], all.node.data() + all.start[a + 1]}, count,
                     coarse.mode.data() + area * a);
  });
  return T;
}

BlockCsr<double> smoothed_prolongator(const BlockCsr<double>& system, const BlockCsr<double>& filtered,
                                      const std::vector<double>& inverse, const BlockCsr<double>& tentative) {
  const double eigenvalue = largest_eigenvalue(system, inverse);
  const double omega = eigenvalue > 0 ? 4.0 / 3.0 / eigenvalue : 0;
  BlockCsr<double> P = product(filtered, tentative);
  const int b = P.height, w = P.width;
  for_ranges(P.rows, least_rows, [&](int begin, int end, int) {
    for (int i = begin; i < end; ++i) {
      const double* D = inverse.data() + static_cast<std::size_t>(i) * b * b;
      for (int k = P.start[i]; k < P.start[i + 1]; ++k)
        for (int c = 0; c < w; ++c) {
          double sums[6] = {};
          for (int r = 0; r < b; ++r)
            for (int m = 0; m < b; ++m) sums[r] -= omega * D[b * r + m] * P.block(k)[w * m + c];
          for (int r = 0; r < b; ++r) P.block(k)[w * r + c] = sums[r];
        }
      if (tentative.start[i] == tentative.start[i + 1]) continue;
      double* own = P.block(P.find(i, tentative.column[tentative.start[i]]));
      for (int e = 0; e < b * w; ++e) own[e] += tentative.block(tentative.start[i])[e];
    }
  });
  return P;
}

}  // namespace isostretch::sparse
