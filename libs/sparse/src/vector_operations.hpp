#pragma once

#include <vector>

namespace isostretch::sparse {

// Sums over long vectors: blocks of fixed length are summed by whichever thread, and the blocks in order.
// Results are the same bits for any number of threads.

// a . b
double dot(const std::vector<double>& a, const std::vector<double>& b);
// x += step * p, r -= step * q; returns r . r
double advance(double step, const std::vector<double>& p, const std::vector<double>& q,
               std::vector<double>& x, std::vector<double>& r);
// p = z + factor * p
void update_direction(const std::vector<double>& z, double factor, std::vector<double>& p);
// r = b - r; returns r . r
double residual_from_product(const std::vector<double>& b, std::vector<double>& r);
// Largest magnitude.
double max_magnitude(const double* x, int size);

}  // namespace isostretch::sparse
