#include "overlap_parts.hpp"

#include "minimum_cut.hpp"
#include "triangle_graph.hpp"

#include <isostretch/core/index.hpp>
#include <isostretch/mesh/measure.hpp>
#include <isostretch/surface/overlap.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <queue>
#include <utility>

namespace isostretch::mesh {
namespace {

// Counted from 0 in the order of their first triangles.
std::vector<int> numbered(const std::vector<int>& labels) {
  std::map<int, int> number;
  std::vector<int> parts;
  for (const int part : labels)
    parts.push_back(number.emplace(part, static_cast<int>(number.size())).first->second);
  return parts;
}

class Divider {
 public:
  Divider(const Cut& cut, const Points2& uv, const Partners& others, int spur_detour)
      : triangles_(cut.mesh.triangles),
        uv_(uv),
        graph_(triangle_graph(cut, spur_detour)),
        others_(others),
        part_(cut.chart.size(), -1) {}

  std::vector<int> divide() {
    std::vector<int> all(part_.size());
    for (std::size_t t = 0; t < all.size(); ++t) all[t] = static_cast<int>(t);
    separate(all);
    for (std::size_t part = 0; part < members_.size(); ++part) divide_part(static_cast<int>(part));
    unite();
    return numbered(part_);
  }

 private:
  bool conflict(int a, int b) const { return part_[at(a)] == part_[at(b)]; }

  int across(int h) const {
    const int opposite = graph_.opposite[at(h)];
    return opposite < 0 ? -1 : opposite / 3;
  }

  template <class Visit>
  void for_each_side(int t, const Visit& visit) const {
    for (int h = 3 * t; h < 3 * t + 3; ++h)
      if (across(h) >= 0) visit(across(h), h);
  }

  // Connected ones of the triangles, where `same` says which neighbours belong together.
  template <class Same>
  std::vector<std::vector<int>> connected(const std::vector<int>& triangles, const Same& same) const {
    std::vector<std::vector<int>> pieces;
    std::vector<char> seen(part_.size(), 0);
    for (const int first : triangles) {
      if (seen[at(first)]) continue;
      std::vector<int> piece{first};
      seen[at(first)] = 1;
      for (std::size_t i = 0; i < piece.size(); ++i)
        for_each_side(piece[i], [&](int other, int) {
          if (seen[at(other)] || !same(piece[i], other)) return;
          seen[at(other)] = 1;
          piece.push_back(other);
        });
      std::sort(piece.begin(), piece.end());
      pieces.push_back(std::move(piece));
    }
    return pieces;
  }

  // Makes new parts of what is connected among triangles of one part.
  void separate(const std::vector<int>& triangles) {
    std::vector<char> inside(part_.size(), 0);
    for (const int t : triangles) inside[at(t)] = 1;
    for (std::vector<int>& piece : connected(triangles, [&](int, int b) { return inside[at(b)] != 0; })) {
      for (const int t : piece) part_[at(t)] = static_cast<int>(members_.size());
      members_.push_back(std::move(piece));
    }
  }

  // What comes of it is looked at later. Most parts have no overlap, and cost nothing but that look.
  void divide_part(int part) {
    const std::vector<int> overlapped = overlapped_among(members_[at(part)]);
    if (overlapped.empty()) return;
    std::vector<signed char> mark(part_.size(), -1);
    for (const int t : members_[at(part)]) mark[at(t)] = 0;
    choose_sides(overlapped, mark);
    const std::vector<char> near = minimum_cut(graph_, mark);
    std::vector<int> first, rest;
    for (const int t : members_[at(part)]) (near[at(t)] ? first : rest).push_back(t);
    members_[at(part)].clear();
    separate(first);
    separate(rest);
  }

  // Those of the triangles of one part that lie on another of it.
  std::vector<int> overlapped_among(const std::vector<int>& part) const {
    std::vector<int> overlapped;
    std::copy_if(part.begin(), part.end(), std::back_inserter(overlapped), [&](int t) {
      return std::any_of(others_[at(t)].begin(), others_[at(t)].end(),
                         [&](int other) { return conflict(t, other); });
    });
    return overlapped;
  }

  // Triangles that must come apart: those of two patches that lie on each other, the largest such pair; or
  // else of one patch that lies on itself.
  void choose_sides(const std::vector<int>& overlapped, std::vector<signed char>& mark) const {
    std::vector<char> in(part_.size(), 0);
    for (const int t : overlapped) in[at(t)] = 1;
    const auto patches = connected(overlapped, [&](int, int b) { return in[at(b)] != 0; });
    std::vector<int> patch(part_.size(), -1);
    for (std::size_t p = 0; p < patches.size(); ++p)
      for (const int t : patches[p]) patch[at(t)] = static_cast<int>(p);
    std::map<std::pair<int, int>, long> count;
    for (const int t : overlapped)
      for (const int other : others_[at(t)])
        if (conflict(t, other) && patch[at(t)] <= patch[at(other)]) ++count[{patch[at(t)], patch[at(other)]}];
    std::pair<int, int> most{-1, -1};
    long highest = 0;
    for (const auto& [pair, pairs] : count)
      if (pair.first != pair.second && pairs > highest) highest = pairs, most = pair;
    if (most.first < 0)
      mark_by_growing(patches[at(count.begin()->first.first)], mark);
    else
      mark_pair(overlapped, patch, most, mark);
  }

  void mark_pair(const std::vector<int>& overlapped, const std::vector<int>& patch,
                 const std::pair<int, int>& pair, std::vector<signed char>& mark) const {
    for (const int t : overlapped)
      for (const int other : others_[at(t)])
        if (conflict(t, other) && patch[at(t)] == pair.first && patch[at(other)] == pair.second) {
          mark[at(t)] = 1;
          mark[at(other)] = 2;
        }
  }

  // From the end of the patch as far as nothing lies on what came before.
  void mark_by_growing(const std::vector<int>& patch, std::vector<signed char>& mark) const {
    std::vector<char> taken(part_.size(), 0), refused(part_.size(), 0);
    for (const int t : in_reach_of(end_of(patch, mark), mark)) {
      const auto& others = others_[at(t)];
      const bool free =
          std::none_of(others.begin(), others.end(), [&](int other) { return taken[at(other)]; });
      (free ? taken : refused)[at(t)] = 1;
    }
    for (const int t : patch) {
      if (refused[at(t)]) mark[at(t)] = 2;
      if (taken[at(t)] && std::any_of(others_[at(t)].begin(), others_[at(t)].end(),
                                      [&](int other) { return refused[at(other)]; }))
        mark[at(t)] = 1;
    }
  }

  int end_of(const std::vector<int>& patch, const std::vector<signed char>& mark) const {
    return in_reach_of(in_reach_of(patch.front(), mark).back(), mark).back();
  }

  // The triangles of the part by their distance in the layout, across triangles.
  std::vector<int> in_reach_of(int start, const std::vector<signed char>& mark) const {
    std::vector<double> distance(part_.size(), std::numeric_limits<double>::infinity());
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    distance[at(start)] = 0;
    queue.emplace(0.0, start);
    std::vector<int> order;
    while (!queue.empty()) {
      const auto [from, t] = queue.top();
      queue.pop();
      if (from > distance[at(t)]) continue;
      order.push_back(t);
      for_each_side(t, [&, from = from, t = t](int other, int) {
        if (mark[at(other)] < 0) return;
        const double through = from + (centre(t) - centre(other)).norm();
        if (through < distance[at(other)]) {
          distance[at(other)] = through;
          queue.emplace(through, other);
        }
      });
    }
    return order;
  }

  Eigen::RowVector2d centre(int t) const {
    return (uv_.row(triangles_(t, 0)) + uv_.row(triangles_(t, 1)) + uv_.row(triangles_(t, 2))) / 3;
  }

  // Undoes cuts that the others have made needless, the longest first.
  void unite() {
    for (;;) {
      std::map<std::pair<int, int>, long long> shared;
      for (std::size_t t = 0; t < part_.size(); ++t)
        for_each_side(static_cast<int>(t), [&](int other, int h) {
          if (part_[t] < part_[at(other)]) shared[{part_[t], part_[at(other)]}] += graph_.capacity[at(h)];
        });
      for (std::size_t t = 0; t < part_.size(); ++t)
        for (const int other : others_[t]) shared.erase(std::minmax(part_[t], part_[at(other)]));
      if (shared.empty()) return;
      const auto longest = std::max_element(shared.begin(), shared.end(),
                                            [](const auto& a, const auto& b) { return a.second < b.second; });
      for (int& part : part_)
        if (part == longest->first.second) part = longest->first.first;
    }
  }

  const Triangles& triangles_;
  const Points2& uv_;
  TriangleGraph graph_;
  const Partners& others_;
  std::vector<int> part_;
  std::vector<std::vector<int>> members_;  // of every part; none of what was divided
};

}  // namespace

Partners overlap_partners(const Cut& cut, const Points2& uv) {
  std::map<int, std::vector<int>> members;
  for (std::size_t t = 0; t < cut.chart.size(); ++t) members[cut.chart[t]].push_back(static_cast<int>(t));
  Partners partners(cut.chart.size());
  for (const auto& [chart, triangles] : members) {
    Triangles own(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t i = 0; i < triangles.size(); ++i)
      own.row(static_cast<Eigen::Index>(i)) = cut.mesh.triangles.row(triangles[i]);
    for (const auto& [i, j] : overlapping_pairs(uv, own)) {
      partners[at(triangles[at(i)])].push_back(triangles[at(j)]);
      partners[at(triangles[at(j)])].push_back(triangles[at(i)]);
    }
  }
  return partners;
}

std::vector<int> parts_without_overlap(const Cut& cut, const Points2& uv, const Partners& partners,
                                       int spur_detour) {
  if (std::all_of(partners.begin(), partners.end(), [](const auto& others) { return others.empty(); }))
    return numbered(cut.chart);
  return Divider(cut, uv, partners, spur_detour).divide();
}

}  // namespace isostretch::mesh
