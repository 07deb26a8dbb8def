#include <isostretch/assembly/block_assembler.hpp>
#include <isostretch/assembly/least_parallel.hpp>
#include <isostretch/core/error.hpp>

#include <omp.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace isostretch::assembly {

BlockAssembler::BlockAssembler(const Restriction& restriction, const HessianPattern& pattern)
    : pattern_(&pattern) {
  constexpr std::size_t most = 0x7fffffff;
  const int nodes = restriction.nodes_per_element();
  const std::size_t elements = restriction.element_count();
  if (elements * static_cast<std::size_t>(pairs(nodes)) > most)
    throw Error(std::to_string(elements) + " elements are more than one term can assemble");
  std::vector<std::pair<std::size_t, Contribution>> found;
  found.reserve(elements * static_cast<std::size_t>(pairs(nodes)));
  Contribution slot = 0;
  for (std::size_t e = 0; e < elements; ++e) {
    const int* node = restriction.nodes(e);
    for (int a = 0; a < nodes; ++a)
      for (int b = a; b < nodes; ++b, ++slot) {
        // Rows of a stored block belong to a; the pattern wants the larger node in the rows.
        found.push_back({pattern.block(node[a], node[b]), 2 * slot + (node[a] < node[b] ? 1 : 0)});
        // A node that an element has twice, as collapsed hexahedra do, gets both blocks of the pair.
        if (a != b && node[a] == node[b]) found.push_back({found.back().first, 2 * slot + 1});
      }
  }
  start_.assign(pattern.block_count() + 1, 0);
  for (const auto& [block, contribution] : found) ++start_[block + 1];
  for (std::size_t i = 0; i < pattern.block_count(); ++i) start_[i + 1] += start_[i];
  contributions_.resize(found.size());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (const auto& [block, contribution] : found) contributions_[next[block]++] = contribution;
}

void BlockAssembler::for_ranges(const std::function<void(std::size_t, std::size_t)>& body) const {
  const std::size_t blocks = pattern_->block_count();
#pragma omp parallel if (blocks > least_parallel)
  {
    const auto parts = static_cast<std::size_t>(omp_get_num_threads()),
               part = static_cast<std::size_t>(omp_get_thread_num());
    body(blocks * part / parts, blocks * (part + 1) / parts);
  }
}

template <int Dim>
void BlockAssembler::add_stored_blocks(const double* stored, double* values) const {
  constexpr std::size_t entries = Dim * Dim;
  constexpr std::size_t ahead = 24;  // blocks come from memory, not from cache: ask for them in time
  const std::size_t last = contributions_.size() - 1;
  for_ranges([&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      std::array<double, entries> sum{};
      for (std::size_t k = start_[block]; k < start_[block + 1]; ++k) {
        __builtin_prefetch(stored + (contributions_[std::min(k + ahead, last)] >> 1) * entries);
        const double* from = stored + (contributions_[k] >> 1) * entries;
        if (contributions_[k] & 1u) {
          for (std::size_t r = 0; r < Dim; ++r)
            for (std::size_t s = 0; s < Dim; ++s) sum[r * Dim + s] += from[s * Dim + r];
        } else {
          for (std::size_t e = 0; e < entries; ++e) sum[e] += from[e];
        }
      }
      add_block(block, sum.data(), entries, values);
    }
  });
}

void BlockAssembler::add_stored(const double* blocks, double* values) const {
  if (contributions_.empty()) return;
  switch (pattern_->unknowns().dim()) {
    case 1:
      return add_stored_blocks<1>(blocks, values);
    case 2:
      return add_stored_blocks<2>(blocks, values);
    default:
      return add_stored_blocks<3>(blocks, values);
  }
}

}  // namespace isostretch::assembly
