#include "schedule.hpp"

#include "front.hpp"

#include <algorithm>

namespace isostretch::cholesky {
namespace {

class ScheduleBuilder {
 public:
  ScheduleBuilder(const Structure& structure, Schedule& schedule)
      : structure_(structure),
        schedule_(schedule),
        unit_of_(static_cast<std::size_t>(structure.count()), -1) {
    choose_subtrees();
    make_units();
    link();
  }

 private:
  const Supernode& node(int s) const { return structure_.supernode[s]; }

  // Units that hand an update matrix on, were subtrees of at most so many operations one unit each.
  int units_below_others(double most_of_subtree) const {
    int count = 0;
    for (int s = 0; s < structure_.count(); ++s)
      count += node(s).parent >= 0 && node(node(s).parent).subtree_flops > most_of_subtree;
    return count;
  }

  // Subtrees are small enough that the last one does not keep several threads waiting. Where the tree is a
  // chain, or a node has thousands of children, they are larger: planning where update matrices lie takes
  // time that grows with the square of their number.
  void choose_subtrees() {
    constexpr int most_units = 256;
    for (int s = 0; s < structure_.count(); ++s)
      if (node(s).parent < 0) schedule_.flops += node(s).subtree_flops;
    double subtrees = 128;
    while (subtrees > 1 && units_below_others(schedule_.flops / subtrees) > most_units) subtrees /= 2;
    schedule_.most_of_subtree = schedule_.flops / subtrees;
  }

  void make_units() {
    const auto is_top = [&](int s) { return node(s).subtree_flops > schedule_.most_of_subtree; };
    std::vector<int> first(unit_of_.size());
    for (int s = 0; s < structure_.count(); ++s) {
      const bool is_leaf = node(s).child == node(s + 1).child;
      first[s] = is_leaf ? s : first[structure_.child[static_cast<std::size_t>(node(s).child)]];
      schedule_.most_rows = std::max(schedule_.most_rows, node(s).rows);
      if (!is_top(s) && node(s).parent >= 0 && !is_top(node(s).parent)) continue;
      const int number = static_cast<int>(schedule_.unit.size());
      unit_of_[s] = number;
      (is_top(s) ? schedule_.top : schedule_.subtree).push_back(number);
      schedule_.unit.push_back(
          {is_top(s) ? s : first[s], s, is_top(s), -1, 0, node(s).subtree_flops, 0, false});
      for (int k = schedule_.unit.back().begin; k <= s; ++k) schedule_.unit.back().changes |= node(k).is_last;
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

  const Structure& structure_;
  Schedule& schedule_;
  std::vector<int> unit_of_;  // of every supernode that is the root of one
};

}  // namespace

Schedule::Schedule(const Structure& structure) {
  ScheduleBuilder(structure, *this);
}

std::int64_t update_values(const Supernode& supernode) {
  return trapezoid_values(supernode.update_rows(), supernode.update_rows());
}

}  // namespace isostretch::cholesky
