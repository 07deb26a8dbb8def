#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

#include <vector>

namespace isostretch::baselines {

// F of linear elements, one after the other in the layout of batches: entry (r, c) of element e at
// (r + dim * c) * count + e.
std::vector<double> deformation_gradients(const assembly::Elements& elements, const Vector& x);

// S = sym(R^T F) from these, in the same layout.
std::vector<double> constraint_matrices(const sdp_penalty::Problem& problem, const std::vector<double>& F);

}  // namespace isostretch::baselines
