#pragma once

#include <isostretch/projection/point_chunk.hpp>

#include <cstddef>

namespace isostretch::projection {
struct FilterOptions;
}

namespace isostretch::assembly {

// One chunk of elements in structure-of-arrays order; entry e of element i at data[e * stride + i].
struct ElementChunk {
  int count;                // projection::padded_count(real), the last element repeated
  int real;                 // elements that count
  std::size_t stride;       // projection::chunk_size(dim)
  const int* nodes;         // nodes_per_element entries
  const double* gradients;  // nodes_per_element * dim entries, of one quadrature point
  const double* weights;    // 1 entry, of one quadrature point
  double scale;             // of the weights
  const double* filtered;   // 1 entry: 0 where the Hessian stays exact; null filters all
};

// Kernels for one dimension and number of nodes per element.
struct ElementKernels {
  int nodes;
  // Positions of the nodes of a chunk: nodes * dim entries of X from the interleaved global vector.
  void (*gather)(const ElementChunk& chunk, const double* x, double* X);
  // F, and from it sigma and, with vectors, U and V.
  void (*deform)(const ElementChunk& chunk, const double* X, const projection::PointChunk& points,
                 bool vectors);
  // Adds to G (nodes * dim entries) the gradient and, when H is given, to H (blocks a <= b of nodes, dim *
  // dim entries each, row-major) the filtered Hessian of the chunk. Returns at how many real points some
  // eigenvalue was changed.
  int (*differentiate)(const ElementChunk& chunk, const projection::PointChunk& points,
                       const projection::FilterOptions& filter, bool coupled, double* G, double* H);
  // Coefficients of det(F + t dF) as a polynomial in t, F from X and dF from DX: dim + 1 entries.
  void (*determinant)(const ElementChunk& chunk, const double* X, const double* DX, double* coefficients);
};

struct AssemblyKernels {
  ElementKernels planar[3];  // 3, 4, 6 nodes
  ElementKernels solid[3];   // 4, 8, 10 nodes
};

}  // namespace isostretch::assembly
