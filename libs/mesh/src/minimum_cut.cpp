#include "minimum_cut.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace isostretch::mesh {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

class Flow {
 public:
  Flow(const TriangleGraph& graph, const std::vector<signed char>& mark)
      : graph_(graph), mark_(mark), left_(graph.capacity), level_(mark.size(), -1), next_(mark.size(), 0) {}

  std::vector<char> separate() {
    while (find_levels())
      for (std::size_t t = 0; t < mark_.size(); ++t)
        if (mark_[t] == 1)
          while (augment(static_cast<int>(t))) continue;
    std::vector<char> near(mark_.size());
    for (std::size_t t = 0; t < near.size(); ++t) near[t] = level_[t] >= 0;
    return near;
  }

 private:
  int beyond(int h) const { return graph_.opposite[at(h)] < 0 ? -1 : graph_.opposite[at(h)] / 3; }

  bool passes(int h) const {
    const int t = beyond(h);
    return t >= 0 && mark_[at(t)] >= 0 && left_[at(h)] > 0;
  }

  // How many sides triangles are away from the first ones. Returns whether a second one is reached.
  bool find_levels() {
    std::fill(level_.begin(), level_.end(), -1);
    std::fill(next_.begin(), next_.end(), 0);
    std::vector<int> queue;
    for (std::size_t t = 0; t < mark_.size(); ++t)
      if (mark_[t] == 1) {
        level_[t] = 0;
        queue.push_back(static_cast<int>(t));
      }
    bool reached = false;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const int t = queue[i];
      if (mark_[at(t)] == 2) {
        reached = true;
        continue;
      }
      for (int h = 3 * t; h < 3 * t + 3; ++h)
        if (passes(h) && level_[at(beyond(h))] < 0) {
          level_[at(beyond(h))] = level_[at(t)] + 1;
          queue.push_back(beyond(h));
        }
    }
    return reached;
  }

  // Sends along one path of rising levels what fits through it.
  bool augment(int from) {
    std::vector<int>& path = path_;
    path.clear();
    for (int t = from;;) {
      if (mark_[at(t)] == 2) break;
      int& corner = next_[at(t)];
      while (corner < 3 &&
             !(passes(3 * t + corner) && level_[at(beyond(3 * t + corner))] == level_[at(t)] + 1))
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
    for (const int h : path) {
      left_[at(h)] -= most;
      left_[at(graph_.opposite[at(h)])] += most;
    }
    return true;
  }

  const TriangleGraph& graph_;
  const std::vector<signed char>& mark_;
  std::vector<long long> left_;
  std::vector<int> level_, next_, path_;
};

}  // namespace

std::vector<char> minimum_cut(const TriangleGraph& graph, const std::vector<signed char>& mark) {
  return Flow(graph, mark).separate();
}

}  // namespace isostretch::mesh
