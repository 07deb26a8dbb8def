#pragma once

#include <isostretch/assembly/hessian_pattern.hpp>
#include <isostretch/sparse/matrix.hpp>

#include <functional>
#include <vector>

namespace isostretch::newton {

// Free unknowns of which some are the same one: T^T H T for the matrix T of zeros and ones that maps the
// fewer unknowns to the free ones. The terms assemble H as if there were no equality constraints; every entry
// then goes to its place.
class EqualityConstraints {
 public:
  // free: what is not pinned; unreduced: the matrix over it.
  EqualityConstraints(const assembly::FreeUnknowns& free, const sparse::SymmetricMatrix& unreduced,
                      const std::function<int(int)>& representative_dof);

  // The unknown that a free unknown is.
  int unknown(int free) const { return unknown_[static_cast<std::size_t>(free)]; }
  const sparse::SymmetricMatrix& zero_matrix() const { return matrix_; }

  // Values of H, to be filled by the terms; reduce() adds them up into values of the smaller matrix.
  std::vector<double>& unreduced_values() { return values_; }
  void reduce(std::vector<double>& values) const;

 private:
  void number_unknowns(const assembly::FreeUnknowns& free, const std::vector<int>& group,
                       const std::function<int(int)>& representative_dof);
  void place_entries(const sparse::SymmetricMatrix& unreduced);

  std::vector<int> unknown_;
  std::vector<double> values_;
  std::vector<int> place_;          // of every entry of H
  std::vector<bool> counts_twice_;  // an entry off the diagonal that ends on it, as its mirror image does
  sparse::SymmetricMatrix matrix_;
};

}  // namespace isostretch::newton
