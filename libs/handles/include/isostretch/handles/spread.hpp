#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/sparse/options.hpp>

#include <memory>
#include <string>
#include <vector>

namespace isostretch::handles {

/// With K_ab = sum over quadrature points of w g_a . g_b and the lumped mass M, in which every element shares
/// its volume equally among its nodes:
enum class SpreadKind {
  harmonic,    ///< K u = 0 at free nodes: no overshoot, kinks at the handles
  biharmonic,  ///< K M^-1 K u = 0: smooth at the handles, may overshoot
};

/// Solver options that factorise whatever it takes, as long as it fits into memory.
sparse::Options factorizing();

/// Spreads displacements given at some nodes to all others, for any dimension and element. The system is
/// factorised once. A component without a given node, and a node of no element, stays where it is.
class Spreader {
 public:
  /// Throws Error when the elements are malformed, a node is out of range, or the system cannot be
  /// factorised.
  Spreader(const assembly::Elements& elements, const std::vector<int>& given, SpreadKind kind,
           const sparse::Options& solver = factorizing());
  ~Spreader();
  Spreader(Spreader&&) noexcept;
  Spreader& operator=(Spreader&&) noexcept;

  /// `displacement` has dim entries a node, of which those of given nodes are read; these come out unchanged.
  /// Throws Error for a wrong size and when the linear solver fails.
  Vector spread(const Vector& displacement) const;

 private:
  struct System;
  std::unique_ptr<System> system_;
};

}  // namespace isostretch::handles
