#pragma once

#include <cstddef>

namespace isostretch::sdp_penalty {

/// Computes S = sym(R^T F), the matrix that is kept positive semi-definite (Liu et al. 2016, section 4), of
/// `count` elements. `rotations` are dim * dim entries an element, column by column, one element after the
/// other; F and S are batches with entry (r, c) of element e at (r + dim * c) * stride + e, and may not
/// overlap.
void isotropic_stretches(int dim, std::size_t count, const double* rotations, const double* F, double* S,
                         std::size_t stride);

}  // namespace isostretch::sdp_penalty
