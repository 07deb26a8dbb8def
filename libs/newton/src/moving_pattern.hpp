#pragma once

#include <isostretch/newton/term.hpp>

#include <memory>
#include <vector>

namespace isostretch::newton {

// The terms whose stencil moves, the pattern of their pairs, and its union with the pattern of all the
// others. The union is made by merging sorted columns: after a move only the pairs that move are sorted.
class MovingPattern {
 public:
  MovingPattern(const assembly::HessianPattern& fixed, std::vector<Term*> terms);

  // Makes the pattern again if a term says that its stencil has moved. Returns whether one has.
  bool follow(const assembly::HessianPattern& fixed);

  // With the union of the patterns.
  const sparse::SymmetricMatrix& zero_matrix() const { return matrix_; }
  // Of the fixed pattern, to be filled by the terms that it belongs to.
  std::vector<double>& fixed_values() { return fixed_values_; }
  // Values of the union: the sum of fixed_values() and of what the moving terms add.
  void add_hessians(std::vector<double>& values);

 private:
  void make(const assembly::HessianPattern& fixed);
  void merge(const sparse::SymmetricMatrix& fixed, const sparse::SymmetricMatrix& moving);

  std::vector<Term*> terms_;
  std::vector<int> versions_;  // of the terms' stencils
  std::unique_ptr<assembly::HessianPattern> pattern_;
  sparse::SymmetricMatrix matrix_;
  std::vector<double> fixed_values_, moving_values_;
  std::vector<int> place_of_fixed_, place_of_moving_;  // in the union
};

}  // namespace isostretch::newton
