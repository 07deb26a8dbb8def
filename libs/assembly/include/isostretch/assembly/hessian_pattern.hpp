#pragma once

#include <isostretch/sparse/matrix.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isostretch::assembly {

/// Unknowns are numbered node by node: degree of freedom dim * node + axis. Pinned ones are eliminated: they
/// keep their value, and the rest is numbered consecutively as the unknowns of the linear systems.
class FreeUnknowns {
 public:
  FreeUnknowns() = default;
  /// pinned: one flag per degree of freedom, or empty for none.
  FreeUnknowns(int dim, int node_count, const std::vector<bool>& pinned = {});

  int dim() const { return dim_; }
  int node_count() const { return node_count_; }
  int dofs() const { return dim_ * node_count_; }
  int size() const { return static_cast<int>(dof_.size()); }
  /// Unknown of a degree of freedom, -1 where pinned; and back.
  int unknown(int dof) const { return unknown_[static_cast<std::size_t>(dof)]; }
  int dof(int unknown) const { return dof_[static_cast<std::size_t>(unknown)]; }

 private:
  int dim_ = 0;
  int node_count_ = 0;
  std::vector<int> unknown_;
  std::vector<int> dof_;
};

/// Which pairs of nodes interact. Pairs may be added in any order and more than once.
class PatternBuilder {
 public:
  explicit PatternBuilder(int node_count) : node_count_(node_count) {}
  void add_pair(int i, int j);
  /// All pairs within a group of nodes, an element for example.
  void add_clique(const int* nodes, int count);

 private:
  friend class HessianPattern;
  int node_count_;
  std::vector<std::uint64_t> pairs_;  ///< high word: smaller node, low word: larger
};

/// The fixed sparsity of a Hessian: its dim x dim blocks between nodes i >= j, and where their entries sit in
/// the lower triangle in compressed columns over the free unknowns.
class HessianPattern {
 public:
  HessianPattern() = default;
  /// Every node gets a diagonal block, coupled or not.
  HessianPattern(FreeUnknowns unknowns, PatternBuilder builder);

  const FreeUnknowns& unknowns() const { return unknowns_; }
  std::size_t block_count() const { return block_pairs_.size(); }
  /// Index of the block between two nodes in either order; throws Error when they are not coupled.
  std::size_t block(int i, int j) const;
  /// Row-major dim x dim positions in the matrix values of the entries of a block, -1 where pinned or above
  /// the diagonal. The row belongs to the larger node, the column to the smaller.
  const int* positions(std::size_t block) const {
    return positions_.data() + block * static_cast<std::size_t>(unknowns_.dim() * unknowns_.dim());
  }

  /// The matrix with this pattern and zero values, grouped by node for the ordering.
  const sparse::SymmetricMatrix& zero_matrix() const { return matrix_; }

 private:
  void build_matrix();

  FreeUnknowns unknowns_;
  std::vector<std::uint64_t> block_pairs_;  ///< sorted by smaller node, then larger
  std::vector<std::size_t> node_start_;     ///< first block of each smaller node
  std::vector<int> positions_;
  sparse::SymmetricMatrix matrix_;
};

}  // namespace isostretch::assembly
