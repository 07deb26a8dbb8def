#pragma once

#include "block_csr.hpp"

#include <isostretch/sparse/matrix.hpp>

#include <vector>

namespace isostretch::sparse {

// Positions of nodes and the axis of every unknown, as Solver::set_coordinates() got them.
struct Coordinates {
  std::vector<double> position;  // dim a group
  std::vector<int> axis;         // of each unknown, or empty
  int dim = 0;                   // 0: none
};

// The matrix as the iterative solver works on it: both triangles, by rows of equal square blocks, one block
// row a node. A node with fewer unknowns than the others (pins, sliding) is filled up with unknowns of their
// own diagonal entry, coupled to nothing. Nodes are renumbered by reverse Cuthill-McKee, so that neighbours
// are close in memory whatever the mesh file's order. Where values go is found once per pattern.
class NodeSystem {
 public:
  // Throws Error when the coordinates do not fit the matrix.
  void analyze(const SymmetricMatrix& A, const Coordinates& coordinates);
  void gather(const std::vector<double>& values);
  // The opposite of gather: values of the caller's matrix.
  void restore(std::vector<double>& values) const;

  const BlockCsr<double>& matrix() const { return matrix_; }
  std::size_t unknowns() const { return slot_of_.size(); }
  int size() const { return static_cast<int>(unknown_of_.size()); }  // of padded vectors
  void pad(const double* x, double* padded) const;                   // 0 where there is no unknown
  void unpad(const double* padded, double* x) const;

  int unknown_of(int slot) const { return unknown_of_[slot]; }  // -1: there to fill up
  int group_of_node(int node) const { return group_of_node_[node]; }
  // Every unknown's axis is its place in the block.
  bool axes_known() const { return axes_known_; }
  // The caller's groups as ranges of slots, also where blocks are smaller than groups.
  const std::vector<int>& group_start() const { return group_start_; }

 private:
  void choose_blocks(const SymmetricMatrix& A, const Coordinates& coordinates);
  void place_unknowns(const SymmetricMatrix& A, const std::vector<int>& order,
                      const Coordinates& coordinates);
  void find_sources(const SymmetricMatrix& A);

  BlockCsr<double> matrix_;
  std::vector<int> first_;    // node of the graph -> first unknown, while analyzing
  std::vector<int> slot_of_;  // unknown -> place in padded vectors
  std::vector<int> unknown_of_;
  std::vector<int> group_of_node_;
  std::vector<int> group_start_;
  std::vector<int> source_;  // entry of matrix_ -> entry of A, or -1
  std::vector<std::size_t> filled_up_;
  std::vector<int> diagonal_;  // of A: its entries on the diagonal
  bool axes_known_ = false;
  bool by_groups_ = false;
};

}  // namespace isostretch::sparse
