#pragma once

#include <isostretch/assembly/hessian_pattern.hpp>
#include <isostretch/assembly/restriction.hpp>
#include <isostretch/linalg/matrix.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace isostretch::assembly {

/// A sum of the blocks of elements, dim x dim and one for every pair of an element's nodes, into the values
/// of a sparse matrix. A matrix entry is the sum of what elements have for it, in the order of elements, in
/// parallel and without atomics: the same bits for any number of threads.
class BlockAssembler {
 public:
  /// Makes an assembler without a pattern, to be assigned to.
  BlockAssembler() = default;
  /// Lists for every block of the pattern which elements add to it. The pattern must hold every pair of nodes
  /// of an element, as Restriction::add_stencil() adds them, and outlive this object where it is. Throws
  /// Error if it does not hold them, or if there are too many elements to number their blocks in 31 bits.
  BlockAssembler(const Restriction& restriction, const HessianPattern& pattern);

  /// Returns the number of pairs a <= b of an element's nodes.
  static constexpr int pairs(int nodes_per_element) {
    return nodes_per_element * (nodes_per_element + 1) / 2;
  }

  /// Adds stored blocks to the values of the matrix: [element][pair a <= b of nodes, by a and then by b][dim
  /// * dim, row by row], with the rows of node a.
  void add_stored(const double* blocks, double* values) const;

  /// Adds blocks that are computed where they are needed to the values of the matrix: block(element, a, b,
  /// sum) adds to `sum` the block of the nodes a and b of an element, with the rows of a. It is called from
  /// several threads.
  template <int Dim, int Nodes, class Block>
  void add_computed(const Block& block, double* values) const {
    static constexpr Pairs<Nodes> pair;
    for_ranges([&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        linalg::Mat<Dim> sum{};
        for (std::size_t k = start_[i]; k < start_[i + 1]; ++k) {
          const Contribution local = contributions_[k] % (2 * pairs(Nodes));
          block(contributions_[k] / (2 * pairs(Nodes)), pair.row[local], pair.column[local], sum);
        }
        add_block(i, sum.m[0], Dim * Dim, values);
      }
    });
  }

 private:
  /// Twice the number of a block among all blocks of elements, plus one where it is wanted transposed.
  using Contribution = std::uint32_t;

  /// The nodes of the block of a contribution, by what it says beside the element.
  template <int Nodes>
  struct Pairs {
    constexpr Pairs() {
      for (int a = 0, k = 0; a < Nodes; ++a)
        for (int b = a; b < Nodes; ++b, k += 2) {
          row[k] = column[k + 1] = a;
          column[k] = row[k + 1] = b;
        }
    }
    int row[2 * pairs(Nodes)]{}, column[2 * pairs(Nodes)]{};
  };

  void add_block(std::size_t block, const double* entries, std::size_t count, double* values) const {
    const int* positions = pattern_->positions(block);
    for (std::size_t e = 0; e < count; ++e)
      if (positions[e] >= 0) values[positions[e]] += entries[e];
  }
  /// Calls body(begin, end) for ranges that make up the blocks of the pattern, one per thread.
  void for_ranges(const std::function<void(std::size_t, std::size_t)>& body) const;
  template <int Dim>
  void add_stored_blocks(const double* blocks, double* values) const;

  const HessianPattern* pattern_ = nullptr;
  std::vector<std::uint32_t> start_;  ///< First contribution to every block of the pattern.
  std::vector<Contribution> contributions_;
};

}  // namespace isostretch::assembly
