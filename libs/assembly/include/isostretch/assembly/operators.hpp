#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/assembly/hessian_pattern.hpp>
#include <isostretch/sparse/matrix.hpp>

#include <vector>

// Matrices over nodes, one unknown each, that many methods share.
namespace isostretch::assembly::operators {

/// Returns the Laplacian K_ab = sum over quadrature points of w g_a . g_b, positive semi-definite, over the
/// nodes that are not pinned; `nodes` has one degree of freedom per node. For linear triangles these are
/// cotangent weights. Entries of nodes that share an element are there even where they are zero.
sparse::SymmetricMatrix laplacian(const Elements& elements, const FreeUnknowns& nodes);

/// Returns the Laplacian K_ab = sum over quadrature points of w g_a . g_b over all nodes, positive
/// semi-definite.
sparse::SymmetricMatrix laplacian(const Elements& elements);

/// Returns the mass of every node at density 1: every element gives its nodes equal shares of its volume. The
/// integral of a shape function would be negative at the corners of quadratic tetrahedra.
std::vector<double> lumped_mass(const Elements& elements);

}  // namespace isostretch::assembly::operators
