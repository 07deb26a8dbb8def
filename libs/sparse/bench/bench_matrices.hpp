#pragma once

// Matrices of meshes of any size, made without triplets so that the memory of a process is that of its
// solver.
#include <isostretch/sparse/matrix.hpp>

#include <string>

namespace isostretch::sparse::bench {

// A square grid of about so many triangles with two unknowns a node, coupled along edges, in an order of
// nodes drawn at random (the same in every run): meshes of the world are not numbered row by row.
SymmetricMatrix grid_of_triangles(int triangles);

// A cube of about so many tetrahedra, six a cell, with three unknowns a node.
SymmetricMatrix cube_of_tetrahedra(int tetrahedra);

// A symmetric matrix of real numbers in coordinates, as the Matrix Market has them. Throws Error for others.
SymmetricMatrix read_matrix_market(const std::string& path);

}  // namespace isostretch::sparse::bench
