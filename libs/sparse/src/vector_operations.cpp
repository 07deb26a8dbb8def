#include "vector_operations.hpp"

#include "parallel.hpp"

#include <cmath>

namespace isostretch::sparse {
namespace {

constexpr int block_length = 4096;
constexpr int least_blocks = 4;

// Four sums side by side: the processor does not wait for one addition to begin the next.
template <class Entry>
double sum_range(int begin, int end, const Entry& entry) {
  double sums[4] = {0, 0, 0, 0};
  int i = begin;
  for (; i + 4 <= end; i += 4)
    for (int lane = 0; lane < 4; ++lane) sums[lane] += entry(i + lane);
  for (; i < end; ++i) sums[0] += entry(i);
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

template <class Entry>
double sum(int size, const Entry& entry) {
  const int blocks = (size + block_length - 1) / block_length;
  std::vector<double> partial(blocks);
  for_ranges(blocks, least_blocks, [&](int begin, int end, int) {
    for (int block = begin; block < end; ++block)
      partial[block] = sum_range(block * block_length, std::min(size, (block + 1) * block_length), entry);
  });
  double total = 0;
  for (const double part : partial) total += part;
  return total;
}

int length(const std::vector<double>& x) {
  return static_cast<int>(x.size());
}

}  // namespace

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return sum(length(a), [&](int i) { return a[i] * b[i]; });
}

double advance(double step, const std::vector<double>& p, const std::vector<double>& q,
               std::vector<double>& x, std::vector<double>& r) {
  return sum(length(p), [&](int i) {
    x[i] += step * p[i];
    r[i] -= step * q[i];
    return r[i] * r[i];
  });
}

void update_direction(const std::vector<double>& z, double factor, std::vector<double>& p) {
  for_ranges(length(p), least_blocks * block_length, [&](int begin, int end, int) {
    for (int i = begin; i < end; ++i) p[i] = z[i] + factor * p[i];
  });
}

double residual_from_product(const std::vector<double>& b, std::vector<double>& r) {
  return sum(length(b), [&](int i) {
    r[i] = b[i] - r[i];
    return r[i] * r[i];
  });
}

double max_magnitude(const double* x, int size) {
  double largest = 0;
  for (int i = 0; i < size; ++i) largest = std::max(largest, std::abs(x[i]));
  return largest;
}

}  // namespace isostretch::sparse
