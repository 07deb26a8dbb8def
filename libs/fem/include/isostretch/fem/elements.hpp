#pragma once

#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/fem/quadrature.hpp>

namespace isostretch::mesh {

// Isoparametric elements as plain arrays; element_arrays.hpp has linear triangles and tets. Whatever the rest
// shape, an affine map has the same F everywhere. Its forces inside a mesh balance exactly (the patch test)
// with the default degree, except for curved quadratic tets, which need 3.

/// Returns bilinear quadrangles as plain arrays, one entry per quadrature point of quadrature_rule(shape,
/// degree). Throws Error naming the element and its vertices when an index is out of range, a coordinate is
/// not finite, or the Jacobian at a quadrature point, which is named too, is not positive: the element is
/// inverted or degenerate.
ElementArrays elements(const QuadMesh& mesh, int degree = default_degree(Shape::quad));
/// Returns trilinear hexahedra as plain arrays, one entry per quadrature point of quadrature_rule(shape,
/// degree). Throws Error naming the element and its vertices when an index is out of range, a coordinate is
/// not finite, or the Jacobian at a quadrature point, which is named too, is not positive: the element is
/// inverted or degenerate.
ElementArrays elements(const HexMesh& mesh, int degree = default_degree(Shape::hex));
/// Returns quadratic triangles as plain arrays, one entry per quadrature point of quadrature_rule(shape,
/// degree). Rest gradients come from the Jacobian of the rest shape at each point, so rest shapes may be
/// curved. Throws Error naming the element and its vertices when an index is out of range, a coordinate is
/// not finite, or the Jacobian at a quadrature point, which is named too, is not positive: the element is
/// inverted, degenerate, or curved too much.
ElementArrays elements(const QuadraticTriangleMesh& mesh,
                       int degree = default_degree(Shape::quadratic_triangle));
/// Returns quadratic tetrahedra as plain arrays, one entry per quadrature point of quadrature_rule(shape,
/// degree). Rest gradients come from the Jacobian of the rest shape at each point, so rest shapes may be
/// curved; forces inside a mesh of curved ones balance exactly under an affine map (the patch test) with
/// degree 3 only. Throws Error naming the element and its vertices when an index is out of range, a
/// coordinate is not finite, or the Jacobian at a quadrature point, which is named too, is not positive: the
/// element is inverted, degenerate, or curved too much.
ElementArrays elements(const QuadraticTetMesh& mesh, int degree = default_degree(Shape::quadratic_tet));

}  // namespace isostretch::mesh
