#pragma once

#include <isostretch/cholesky/run.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace isostretch::cholesky {

/// The pattern of a symmetric matrix by its lower triangle in compressed columns: the rows of column j are
/// row[k], column_start[j] <= k < column_start[j + 1], each of them once, j among them. The arrays are not
/// copied.
struct Pattern {
  int size = 0;                       ///< Rows and columns.
  const int* column_start = nullptr;  ///< size + 1 of them.
  const int* row = nullptr;           ///< column_start[size] of them.
};

/// When a supernode is merged with its parent, which stores zeros but makes the dense kernels longer: up to
/// `columns` columns of both, where zeros are at most the share `zeros` of the entries.
struct Amalgamation {
  int columns[3] = {16, 48, 128};            ///< Columns of both; the last share holds beyond the last.
  double zeros[4] = {0.8, 0.3, 0.15, 0.05};  ///< Largest shares of zeros.
};

/// A supernode: columns of L of one structure, kept as the lower trapezoid of a dense matrix of `rows` x
/// `columns`, the diagonal block on top, in blocks of 192 columns that begin at the diagonal. It is the front
/// of the multifrontal method, whose last rows - columns rows and columns are the update matrix that its
/// parent takes.
struct Supernode {
  int first = 0;            ///< Position of its first column.
  int columns = 0;          ///< Number of its columns.
  int rows = 0;             ///< Number of its rows, the columns' own among them.
  int parent = -1;          ///< Its parent; -1 for a root.
  std::int64_t row = 0;     ///< Where its rows begin in Structure::row, past those of its own columns.
  std::int64_t values = 0;  ///< Where its columns begin among the values of L.
  /// Distance of two columns of the first block, in values. Every later block, which begins at its own
  /// diagonal entry right after the one before, has 192 fewer.
  std::int64_t leading = 0;
  std::int64_t entry = 0;  ///< Where its entries of A begin in Structure::entry.
  std::int64_t child = 0;  ///< Where its children begin in Structure::child.
  std::int64_t run = 0;    ///< Where the runs of its update matrix begin in Structure::run.
  bool is_last = false;    ///< Whether its columns are among those that are eliminated last.
  /// Operations of its subtree, itself included.
  double subtree_flops = 0;
  /// Values that the stack of update matrices has at most while its subtree is eliminated, its own update
  /// matrix included.
  std::int64_t stack = 0;

  /// Returns the size of the update matrix.
  int update_rows() const { return rows - columns; }
};

/// Where an entry of A belongs in the values of a front.
struct EntryPlace {
  int entry = 0;             ///< Number of the entry in the pattern.
  std::uint32_t offset = 0;  ///< Place in the front, in values from its beginning.
};

/// The structure of L: supernodes in the order of elimination, every one after its children.
struct Structure {
  std::vector<Supernode> supernode;  ///< The supernodes; one more ends the lists of the last.
  std::vector<int> row;              ///< Positions of the rows below the diagonal blocks, ascending in each.
  std::vector<int> place_in_parent;  ///< For each entry of `row`, the row of the parent's front.
  std::vector<Run> run;              ///< Rows of update matrices in the fronts of their parents, by runs.
  std::vector<int> child;            ///< Children, in the order in which their update matrices are added.
  std::vector<EntryPlace> entry;     ///< Entries of A by front.
  std::vector<int> order;            ///< Unknown of each position.
  std::int64_t values = 0;           ///< Values of L that are stored, padding included.

  /// Returns the number of supernodes.
  int count() const { return static_cast<int>(supernode.size()) - 1; }
};

/// The symbolic factorization of a pattern: elimination tree, supernodes with relaxed amalgamation, structure
/// of L, an order of the tree with a small stack (Liu 1986). Values play no part, so one analysis serves all
/// matrices of the pattern.
class Analysis {
 public:
  /// Analyses the empty pattern.
  Analysis();
  /// Analyses a pattern whose unknowns are eliminated in `order`, position by position, up to the order of
  /// branches of the elimination tree, which costs nothing; empty: as they are numbered. Throws Error for a
  /// pattern or an order that is none, and for a front of more than 2^32 values.
  ///
  /// The last unknowns of the order, as many as `last` says, have supernodes of their own, so that they can
  /// be factorised again without the others, and have a Schur complement (see Factor).
  explicit Analysis(const Pattern& pattern, std::span<const int> order = {}, const Amalgamation& merge = {},
                    int last = 0);

  /// Returns the structure of L.
  const Structure& structure() const { return structure_; }
  /// Returns the number of rows and columns of the matrix.
  int size() const { return static_cast<int>(structure_.order.size()); }
  /// Returns the unknowns that are eliminated last, in the order that was given.
  const std::vector<int>& last() const { return last_; }
  /// Returns the number of entries of L, the zeros of merged supernodes left out.
  double factor_nonzeros() const { return factor_nonzeros_; }
  /// Returns the operations of a factorization, additions and multiplications, the same zeros left out.
  double factor_flops() const { return factor_flops_; }

 private:
  Structure structure_;
  std::vector<int> last_;
  double factor_nonzeros_ = 0, factor_flops_ = 0;
};

}  // namespace isostretch::cholesky
