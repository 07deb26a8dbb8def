#include <isostretch/assembly/hessian_pattern.hpp>
#include <isostretch/core/error.hpp>

#include <algorithm>
#include <string>
#include <utility>

namespace isostretch::assembly {
namespace {

std::uint64_t pack(int smaller, int larger) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(smaller)) << 32 |
         static_cast<std::uint32_t>(larger);
}
int smaller_of(std::uint64_t pair) {
  return static_cast<int>(pair >> 32);
}
int larger_of(std::uint64_t pair) {
  return static_cast<int>(pair & 0xffffffffu);
}

}  // namespace

FreeUnknowns::FreeUnknowns(int dim, int node_count, const std::vector<bool>& pinned)
    : dim_(dim), node_count_(node_count), unknown_(static_cast<std::size_t>(dim * node_count), -1) {
  if (!pinned.empty() && pinned.size() != unknown_.size())
    throw Error(std::to_string(pinned.size()) + " pin flags for " + std::to_string(unknown_.size()) +
                " degrees of freedom");
  for (std::size_t i = 0; i < unknown_.size(); ++i)
    if (pinned.empty() || !pinned[i]) {
      unknown_[i] = static_cast<int>(dof_.size());
      dof_.push_back(static_cast<int>(i));
    }
}

void PatternBuilder::add_pair(int i, int j) {
  if (std::min(i, j) < 0 || std::max(i, j) >= node_count_)
    throw Error("pair of nodes " + std::to_string(i) + ", " + std::to_string(j) + " is not among the " +
                std::to_string(node_count_) + " there are");
  pairs_.push_back(pack(std::min(i, j), std::max(i, j)));
}

void PatternBuilder::add_clique(const int* nodes, int count) {
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b) add_pair(nodes[a], nodes[b]);
}

HessianPattern::HessianPattern(FreeUnknowns unknowns, PatternBuilder builder)
    : unknowns_(std::move(unknowns)), block_pairs_(std::move(builder.pairs_)) {
  const int nodes = unknowns_.node_count();
  std::sort(block_pairs_.begin(), block_pairs_.end());
  // Diagonal blocks are merged in, so that a few pairs among many nodes are cheap.
  const auto pairs = static_cast<std::ptrdiff_t>(block_pairs_.size());
  for (int i = 0; i < nodes; ++i) block_pairs_.push_back(pack(i, i));
  std::inplace_merge(block_pairs_.begin(), block_pairs_.begin() + pairs, block_pairs_.end());
  block_pairs_.erase(std::unique(block_pairs_.begin(), block_pairs_.end()), block_pairs_.end());
  block_pairs_.shrink_to_fit();
  node_start_.assign(static_cast<std::size_t>(nodes) + 1, 0);
  for (const auto pair : block_pairs_) ++node_start_[static_cast<std::size_t>(smaller_of(pair)) + 1];
  for (std::size_t i = 0; i < static_cast<std::size_t>(nodes); ++i) node_start_[i + 1] += node_start_[i];
  build_matrix();
}

std::size_t HessianPattern::block(int i, int j) const {
  const int smaller = std::min(i, j), larger = std::max(i, j);
  const auto begin =
      block_pairs_.begin() + static_cast<std::ptrdiff_t>(node_start_[static_cast<std::size_t>(smaller)]);
  const auto end =
      block_pairs_.begin() + static_cast<std::ptrdiff_t>(node_start_[static_cast<std::size_t>(smaller) + 1]);
  const auto found = std::lower_bound(begin, end, pack(smaller, larger));
  if (found == end || *found != pack(smaller, larger))
    throw Error("nodes " + std::to_string(i) + " and " + std::to_string(j) +
                " are not coupled in the Hessian pattern");
  return static_cast<std::size_t>(found - block_pairs_.begin());
}

void HessianPattern::build_matrix() {
  const int dim = unknowns_.dim();
  const std::size_t entries = static_cast<std::size_t>(dim) * static_cast<std::size_t>(dim);
  positions_.assign(block_pairs_.size() * entries, -1);
  matrix_.size = unknowns_.size();
  matrix_.column_start.assign(1, 0);
  for (int node = 0; node < unknowns_.node_count(); ++node) {
    const std::size_t begin = node_start_[static_cast<std::size_t>(node)],
                      end = node_start_[static_cast<std::size_t>(node) + 1];
    for (int c = 0; c < dim; ++c) {
      if (unknowns_.unknown(dim * node + c) < 0) continue;
      matrix_.group.push_back(node);
      for (std::size_t k = begin; k < end; ++k) {
        const int other = larger_of(block_pairs_[k]);
        for (int r = other == node ? c : 0; r < dim; ++r) {
          const int row = unknowns_.unknown(dim * other + r);
          if (row < 0) continue;
          positions_[k * entries + static_cast<std::size_t>(r * dim + c)] =
              static_cast<int>(matrix_.row.size());
          matrix_.row.push_back(row);
        }
      }
      matrix_.column_start.push_back(static_cast<int>(matrix_.row.size()));
    }
  }
  matrix_.value.assign(matrix_.row.size(), 0.0);
}

}  // namespace isostretch::assembly
