#include "schedule.hpp"

#include "padding.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace isostretch::cholesky {
namespace {

// Pieces of the pool that nobody needs any more.
class FreeSpace {
 public:
  // The first piece that is large enough; -1: none is.
  std::int64_t take(std::int64_t values) {
    for (const auto& [place, size] : pieces_) {
      if (size < values) continue;
      const std::int64_t taken = place, left = size - values;
      pieces_.erase(taken);
      if (left > 0) pieces_[taken + values] = left;
      return taken;
    }
    return -1;
  }

  void give_back(std::int64_t place, std::int64_t values) {
    if (values == 0) return;
    auto next = pieces_.lower_bound(place);
    if (next != pieces_.end() && place + values == next->first) {
      values += next->second;
      next = pieces_.erase(next);
    }
    if (next != pieces_.begin()) {
      const auto before = std::prev(next);
      if (before->first + before->second == place) {
        before->second += values;
        return;
      }
    }
    pieces_[place] = values;
  }

  void absorb(const FreeSpace& other) {
    for (const auto& [place, size] : other.pieces_) give_back(place, size);
  }

 private:
  std::map<std::int64_t, std::int64_t> pieces_;  // place and size
};

class ScheduleBuilder {
 public:
  ScheduleBuilder(const Structure& structure, Schedule& schedule)
      : structure_(structure),
        schedule_(schedule),
        unit_of_(static_cast<std::size_t>(structure.count()), -1) {
    make_units();
    link();
    place_update_matrices();
  }

 private:
  const Supernode& node(int s) const { return structure_.supernode[s]; }

  void make_units() {
    // Small enough that the last one does not keep several threads waiting.
    constexpr double subtrees = 128;
    for (int s = 0; s < structure_.count(); ++s)
      if (node(s).parent < 0) schedule_.flops += node(s).subtree_flops;
    const auto is_top = [&](int s) { return node(s).subtree_flops > schedule_.flops / subtrees; };
    std::vector<int> first(unit_of_.size());
    for (int s = 0; s < structure_.count(); ++s) {
      const bool is_leaf = node(s).child == node(s + 1).child;
      first[s] = is_leaf ? s : first[structure_.child[static_cast<std::size_t>(node(s).child)]];
      schedule_.most_rows = std::max(schedule_.most_rows, node(s).rows);
      if (!is_top(s) && node(s).parent >= 0 && !is_top(node(s).parent)) continue;
      const int number = static_cast<int>(schedule_.unit.size());
      unit_of_[s] = number;
      (is_top(s) ? schedule_.top : schedule_.subtree).push_back(number);
      schedule_.unit.push_back({is_top(s) ? s : first[s], s, is_top(s), -1, 0, node(s).subtree_flops, 0});
      if (!is_top(s)) schedule_.stack = std::max(schedule_.stack, node(s).stack);
    }
    std::stable_sort(schedule_.subtree.begin(), schedule_.subtree.end(),
                     [&](int a, int b) { return schedule_.unit[a].flops > schedule_.unit[b].flops; });
  }

  void link() {
    for (Unit& unit : schedule_.unit) {
      if (node(unit.root).parent < 0) continue;
      unit.parent = unit_of_[node(unit.root).parent];
      ++schedule_.unit[unit.parent].children;
    }
    std::vector<double> below(schedule_.unit.size(), 0);
    for (const Unit& unit : schedule_.unit)
      if (unit.parent >= 0) below[unit.parent] += unit.flops;
    for (std::size_t u = schedule_.unit.size(); u-- > 0;) {
      Unit& unit = schedule_.unit[u];
      unit.path = unit.flops - below[u] + (unit.parent < 0 ? 0 : schedule_.unit[unit.parent].path);
    }
  }

  void place_update_matrices() {
    schedule_.update.assign(unit_of_.size(), -1);
    std::vector<FreeSpace> free(schedule_.unit.size());
    for (std::size_t u = 0; u < schedule_.unit.size(); ++u) {
      const Unit& unit = schedule_.unit[u];
      const std::int64_t values = update_values(node(unit.root));
      std::int64_t& place = schedule_.update[unit.root];
      place = free[u].take(values);
      if (place < 0) place = std::exchange(schedule_.pool, schedule_.pool + values);
      if (unit.is_top)
        for (std::int64_t k = node(unit.root).child; k < node(unit.root + 1).child; ++k) {
          const int c = structure_.child[static_cast<std::size_t>(k)];
          free[u].give_back(schedule_.update[c], update_values(node(c)));
        }
      if (unit.parent >= 0) free[unit.parent].absorb(std::exchange(free[u], {}));
    }
  }

  const Structure& structure_;
  Schedule& schedule_;
  std::vector<int> unit_of_;  // of every supernode that is the root of one
};

}  // namespace

Schedule::Schedule(const Structure& structure) {
  ScheduleBuilder(structure, *this);
}

std::int64_t update_leading(const Supernode& supernode) {
  return padded(supernode.update_rows());
}

std::int64_t update_values(const Supernode& supernode) {
  return update_leading(supernode) * supernode.update_rows();
}

}  // namespace isostretch::cholesky
