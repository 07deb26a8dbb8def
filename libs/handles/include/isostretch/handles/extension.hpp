#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/sparse/options.hpp>

#include <memory>
#include <string>
#include <vector>

namespace isostretch::handles {

/// The equation by which displacements extend from given nodes to all others. K_ab = sum over quadrature
/// points of w g_a . g_b is the Laplacian, and M the lumped mass, in which every element shares its volume
/// equally among its nodes.
enum class ExtensionKind {
  harmonic,    ///< Solves K u = 0 at free nodes: no overshoot, kinks at the handles.
  biharmonic,  ///< Solves K M^-1 K u = 0: smooth at the handles, may overshoot.
};

/// Returns solver options that factorise whatever it takes, as long as it fits into memory.
sparse::Options factorizing();

/// The harmonic or biharmonic extension of displacements given at some nodes to all others, for any dimension
/// and element. The system is factorised once. A component without a given node, and a node of no element,
/// stays where it is.
class Extension {
  /// Factorises the system for displacements given at the nodes `given`. Throws Error when the elements are
  /// malformed, a node is out of range, or the system cannot be factorised.
 public:
  /// Throws Error when the elements are malformed, a node is out of range, or the system cannot be
  /// factorised.
  Extension(const assembly::Elements& elements, const std::vector<int>& given, ExtensionKind kind,
            const sparse::Options& solver = factorizing());
  ~Extension();
  /// Takes over the other extension, which is left to be destroyed or assigned to.
  Extension(Extension&&) noexcept;
  /// Takes over the other extension, which is left to be destroyed or assigned to.
  Extension& operator=(Extension&&) noexcept;

  /// Returns displacements at all nodes. `displacement` has dim entries per node, of which those of given
  /// nodes are read; these come out unchanged. Throws Error for a wrong size and when the linear solver
  /// fails.
  Vector extend(const Vector& displacement) const;

 private:
  struct System;
  std::unique_ptr<System> system_;
};

}  // namespace isostretch::handles
