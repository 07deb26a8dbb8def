#include <isostretch/assembly/least_parallel.hpp>
#include <isostretch/assembly/restriction.hpp>

#include <array>
#include <utility>

namespace isostretch::assembly {

Restriction::Restriction(std::vector<int> nodes, int nodes_per_element, int node_count)
    : nodes_per_element_(nodes_per_element), nodes_(std::move(nodes)) {
  start_.assign(static_cast<std::size_t>(node_count) + 1, 0);
  for (const int node : nodes_) ++start_[static_cast<std::size_t>(node) + 1];
  for (std::size_t i = 0; i + 1 < start_.size(); ++i) start_[i + 1] += start_[i];
  corner_.resize(nodes_.size());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t k = 0; k < nodes_.size(); ++k) corner_[next[static_cast<std::size_t>(nodes_[k])]++] = k;
}

void Restriction::add_stencil(PatternBuilder& builder) const {
  for (std::size_t e = 0; e < element_count(); ++e) builder.add_clique(nodes(e), nodes_per_element_);
}

template <int Dim>
void Restriction::add_sums(const double* corners, double* x) const {
  const auto count = static_cast<std::size_t>(node_count());
#pragma omp parallel for schedule(static) if (count > least_parallel)
  for (std::size_t node = 0; node < count; ++node) {
    std::array<double, Dim> sum{};
    for (std::size_t k = start_[node]; k < start_[node + 1]; ++k)
      for (std::size_t d = 0; d < Dim; ++d) sum[d] += corners[corner_[k] * Dim + d];
    for (std::size_t d = 0; d < Dim; ++d) x[node * Dim + d] += sum[d];
  }
}

void Restriction::add_transposed(int dim, const double* corners, double* x) const {
  if (dim == 2)
    add_sums<2>(corners, x);
  else
    add_sums<3>(corners, x);
}

}  // namespace isostretch::assembly
