#pragma once

#include <isostretch/sparse/matrix.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isostretch::assembly {

/// The free unknowns among the degrees of freedom of nodes, which are numbered dim * node + axis. Pinned ones
/// are eliminated: they keep their value, and the rest is numbered consecutively as the unknowns of the
/// linear systems.
class FreeUnknowns {
 public:
  /// Makes an empty set, to be assigned to.
  FreeUnknowns() = default;
  /// Numbers the degrees of freedom that are not pinned. `pinned` has a flag per degree of freedom, or is
  /// empty for none.
  FreeUnknowns(int dim, int node_count, const std::vector<bool>& pinned = {});

  /// Returns the number of degrees of freedom per node.
  int dim() const { return dim_; }
  /// Returns the number of nodes.
  int node_count() const { return node_count_; }
  /// Returns the number of degrees of freedom, free and pinned.
  int dofs() const { return dim_ * node_count_; }
  /// Returns the number of unknowns.
  int size() const { return static_cast<int>(dof_.size()); }
  /// Returns the unknown of a degree of freedom, -1 where it is pinned.
  int unknown(int dof) const { return unknown_[static_cast<std::size_t>(dof)]; }
  /// Returns the degree of freedom of an unknown.
  int dof(int unknown) const { return dof_[static_cast<std::size_t>(unknown)]; }

 private:
  int dim_ = 0;
  int node_count_ = 0;
  std::vector<int> unknown_;
  std::vector<int> dof_;
};

/// A collector of the pairs of nodes that interact. Pairs may be added in any order and more than once.
class PatternBuilder {
 public:
  /// Makes a collector without pairs of nodes 0 ... node_count - 1.
  explicit PatternBuilder(int node_count) : node_count_(node_count) {}
  /// Adds the pair of nodes i and j.
  void add_pair(int i, int j);
  /// Adds all pairs within a group of nodes, such as those of an element.
  void add_clique(const int* nodes, int count);

 private:
  friend class HessianPattern;
  int node_count_;
  std::vector<std::uint64_t> pairs_;  ///< The smaller node in the high word, the larger one in the low word.
};

/// The fixed sparsity of a Hessian: its dim x dim blocks between nodes i >= j, and the places of their
/// entries in the lower triangle in compressed columns over the free unknowns.
class HessianPattern {
 public:
  /// Makes an empty pattern, to be assigned to.
  HessianPattern() = default;
  /// Makes the pattern of the pairs that the builder has. Every node gets a diagonal block, coupled or not.
  HessianPattern(FreeUnknowns unknowns, PatternBuilder builder);

  /// Returns the free unknowns, the rows and columns of the matrix.
  const FreeUnknowns& unknowns() const { return unknowns_; }
  /// Returns the number of blocks.
  std::size_t block_count() const { return block_pairs_.size(); }
  /// Returns the index of the block between two nodes in either order. Throws Error when they are not
  /// coupled.
  std::size_t block(int i, int j) const;
  /// Returns the positions of the entries of a block among the values of the matrix, dim x dim row by row, -1
  /// where pinned or above the diagonal. The row belongs to the larger node, the column to the smaller.
  const int* positions(std::size_t block) const {
    return positions_.data() + block * static_cast<std::size_t>(unknowns_.dim() * unknowns_.dim());
  }

  /// Returns the matrix with this pattern and zero values, grouped by node for the ordering.
  const sparse::SymmetricMatrix& zero_matrix() const { return matrix_; }

 private:
  void build_matrix();

  FreeUnknowns unknowns_;
  std::vector<std::uint64_t> block_pairs_;  ///< Sorted by smaller node, then larger.
  std::vector<std::size_t> node_start_;     ///< First block of each smaller node.
  std::vector<int> positions_;
  sparse::SymmetricMatrix matrix_;
};

}  // namespace isostretch::assembly
