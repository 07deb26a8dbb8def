#include "minimum_cut.hpp"

#include <isostretch/core/index.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace isostretch::mesh {
namespace {

class Flow {
 public:
  Flow(const TriangleGraph& graph, const std::vector<signed char>& mark, long long limit)
      : graph_(graph),
        mark_(mark),
        limit_(limit),
        left_(graph.capacity),
        level_(mark.size(), -1),
        next_(mark.size(), 0) {
    for (std::size_t t = 0; t < mark.size(); ++t)
      if (mark[t] > 0) (mark[t] == 1 ? first_ : second_).push_back(static_cast<int>(t));
  }

  std::vector<char> separate() {
    while (find_levels())
      for (const int t : first_)
        while (level_[at(t)] >= 0 && augment(t))
          if (flow_ >= limit_) return {};
    return within_reach();
  }

 private:
  int beyond(int h) const { return graph_.opposite[at(h)] < 0 ? -1 : graph_.opposite[at(h)] / 3; }

  bool passes(int h) const {
    const int t = beyond(h);
    return t >= 0 && mark_[at(t)] >= 0 && left_[at(h)] > 0;
  }

  // How many sides triangles are away from the second ones, up to the nearest of the first. Returns whether
  // there is a way.
  bool find_levels() {
    for (const int t : queue_) level_[at(t)] = -1;
    queue_ = second_;
    for (const int t : queue_) level_[at(t)] = next_[at(t)] = 0;
    int enough = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const int t = queue_[i];
      if (level_[at(t)] >= enough) break;
      if (mark_[at(t)] == 1) enough = level_[at(t)];
      for (int h = 3 * t; h < 3 * t + 3; ++h) {
        const int other = beyond(h);
        if (other < 0 || mark_[at(other)] < 0 || level_[at(other)] >= 0) continue;
        if (left_[at(graph_.opposite[at(h)])] == 0) continue;
        level_[at(other)] = level_[at(t)] + 1;
        next_[at(other)] = 0;
        queue_.push_back(other);
      }
    }
    return enough < std::numeric_limits<int>::max();
  }

  // What the first triangles are still connected to.
  std::vector<char> within_reach() const {
    std::vector<char> near(mark_.size(), 0);
    std::vector<int> queue = first_;
    for (const int t : queue) near[at(t)] = 1;
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (int h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h)
        if (passes(h) && !near[at(beyond(h))]) {
          near[at(beyond(h))] = 1;
          queue.push_back(beyond(h));
        }
    return near;
  }

  // Sends along one path of falling levels what fits through it.
  bool augment(int from) {
    std::vector<int>& path = path_;
    path.clear();
    for (int t = from;;) {
      if (mark_[at(t)] == 2) break;
      int& corner = next_[at(t)];
      while (corner < 3 &&
             !(passes(3 * t + corner) && level_[at(beyond(3 * t + corner))] == level_[at(t)] - 1))
        ++corner;
      if (corner < 3) {
        path.push_back(3 * t + corner);
        t = beyond(path.back());
        continue;
      }
      if (path.empty()) return false;
      t = path.back() / 3;
      path.pop_back();
      ++next_[at(t)];
    }
    long long most = std::numeric_limits<long long>::max();
    for (const int h : path) most = std::min(most, left_[at(h)]);
    flow_ += most;
    for (const int h : path) {
      left_[at(h)] -= most;
      left_[at(graph_.opposite[at(h)])] += most;
    }
    return true;
  }

  const TriangleGraph& graph_;
  const std::vector<signed char>& mark_;
  long long limit_, flow_ = 0;
  std::vector<long long> left_;
  std::vector<int> first_, second_;
  std::vector<int> level_, next_, path_, queue_;
};

}  // namespace

std::vector<char> minimum_cut(const TriangleGraph& graph, const std::vector<signed char>& mark,
                              long long limit) {
  return Flow(graph, mark, limit).separate();
}

}  // namespace isostretch::mesh
