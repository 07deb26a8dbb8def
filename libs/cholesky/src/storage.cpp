#include "storage.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

namespace isostretch::cholesky {
namespace {

// What is above subtrees of more than this share of the operations that one thread should do finds no other
// subtree that keeps the other threads busy: all threads do it together.
constexpr double is_alone_to = 1.1;

// Units that wait for none. No more are ever at work at the same time.
int leaves(const Schedule& schedule) {
  return static_cast<int>(std::count_if(schedule.unit.begin(), schedule.unit.end(),
                                        [](const Unit& unit) { return unit.children == 0; }));
}

// When a unit is begun and done, in operations of one thread.
struct Times {
  double begin = 0, end = 0;
};

// The threads take units as Agenda hands them out.
class Simulation {
 public:
  Simulation(const Schedule& schedule, int threads, double alone)
      : schedule_(schedule), alone_(alone), times_(schedule.unit.size()) {
    for (const Unit& unit : schedule.unit) waiting_.push_back(unit.children);
    for (int u = 0; u < count(); ++u)
      if (waiting_[u] == 0) offer(u);
    while (take(threads)) finish();
    for (int u = 0; u < count(); ++u)
      if (schedule.unit[u].flops > alone) {
        times_[u].begin = now_;
        now_ += work(u) / threads;
        times_[u].end = now_;
      }
  }

  std::vector<Times> times() const { return times_; }

 private:
  int count() const { return static_cast<int>(schedule_.unit.size()); }

  double work(int u) const {
    const Unit& unit = schedule_.unit[u];
    return unit.path - (unit.parent < 0 ? 0 : schedule_.unit[unit.parent].path);
  }

  void offer(int u) {
    if (schedule_.unit[u].flops > alone_) return;
    ready_.emplace_back(schedule_.unit[u].path, u);
    std::push_heap(ready_.begin(), ready_.end());
  }

  // False where nothing is at work after it.
  bool take(int threads) {
    while (!ready_.empty() && static_cast<int>(running_.size()) < threads) {
      std::pop_heap(ready_.begin(), ready_.end());
      const int u = ready_.back().second;
      ready_.pop_back();
      times_[u] = {now_, now_ + work(u)};
      running_.push_back(u);
    }
    return !running_.empty();
  }

  void finish() {
    const auto first = std::min_element(running_.begin(), running_.end(),
                                        [&](int a, int b) { return times_[a].end < times_[b].end; });
    const int parent = schedule_.unit[*first].parent;
    now_ = times_[*first].end;
    running_.erase(first);
    if (parent >= 0 && --waiting_[parent] == 0) offer(parent);
  }

  const Schedule& schedule_;
  double alone_, now_ = 0;
  std::vector<Times> times_;
  std::vector<int> waiting_, running_;
  std::vector<std::pair<double, int>> ready_;  // heap: path and unit
};

// Values that are in use from `begin` to `end`.
struct Lease {
  std::int64_t place = 0, values = 0;
  double begin = 0, end = 0;
  int unit = -1;       // whose columns or update matrix it is; -1: the stack of a thread
  bool again = false;  // needed in a refactorization
  bool kept = false;   // and what a refactorization must not touch

  bool is_beside(const Lease& other) const {
    return (begin < other.end && other.begin < end) || (kept && other.again) || (again && other.kept);
  }
  bool shares(const Lease& other) const {
    return place < other.place + other.values && other.place < place + values;
  }
};

class Planner {
 public:
  Planner(const Structure& structure, const Schedule& schedule, const std::vector<Times>& times, int threads)
      : schedule_(schedule), units_(static_cast<int>(times.size())) {
    constexpr double for_ever = std::numeric_limits<double>::infinity();
    double subtrees_end = 0;
    bool subtrees_change = false;
    for (int u = 0; u < units_; ++u) {
      const Unit& unit = schedule.unit[u];
      const std::int64_t begin = structure.supernode[unit.begin].values;
      fixed_.push_back({begin, structure.supernode[unit.root + 1].values - begin, times[u].begin, for_ever, u,
                        false, !unit.changes});
      if (unit.parent >= 0) {
        const bool kept = !unit.changes && schedule.unit[unit.parent].changes;
        moving_.push_back({0, update_values(structure.supernode[unit.root]), times[u].begin,
                           kept ? for_ever : times[unit.parent].end, u, unit.changes, kept});
      }
      if (unit.is_top) continue;
      subtrees_end = std::max(subtrees_end, times[u].end);
      subtrees_change |= unit.changes;
    }
    moving_.insert(moving_.end(), threads, {0, schedule.stack, 0, subtrees_end, -1, subtrees_change, false});
    find_subtrees();
  }

  // None of these orders is the best for all trees.
  void place() {
    std::vector<Lease> best;
    for (const auto comes_first : {&is_larger, &ends_later, &is_larger_for_longer}) {
      std::stable_sort(moving_.begin(), moving_.end(), comes_first);
      place_in_turn();
      if (best.empty() || end(moving_) < end(best)) best = moving_;
    }
    moving_ = std::move(best);
  }

  void write(Storage& storage) const {
    storage.update.assign(units_, 0);
    storage.values = std::max(end(fixed_), end(moving_));
    for (const Lease& one : moving_) {
      if (one.unit >= 0)
        storage.update[one.unit] = one.place;
      else
        storage.stack.push_back(one.place);
      for (const std::vector<Lease>* others : {&fixed_, &moving_})
        for (const Lease& later : *others)
          if (later.begin >= one.end && later.shares(one)) add_waits(one, later.unit, storage);
    }
    std::sort(storage.waits.begin(), storage.waits.end());
    storage.waits.erase(std::unique(storage.waits.begin(), storage.waits.end()), storage.waits.end());
  }

 private:
  void find_subtrees() {
    first_below_.resize(units_);
    std::iota(first_below_.begin(), first_below_.end(), 0);
    for (int u = 0; u < units_; ++u)
      if (const int parent = schedule_.unit[u].parent; parent >= 0)
        first_below_[parent] = std::min(first_below_[parent], first_below_[u]);
  }

  static bool is_larger(const Lease& a, const Lease& b) { return a.values > b.values; }
  static bool ends_later(const Lease& a, const Lease& b) { return a.end > b.end; }
  static bool is_larger_for_longer(const Lease& a, const Lease& b) {
    const auto size = [](const Lease& one) {
      return static_cast<double>(one.values) * (one.end - one.begin);
    };
    return size(a) > size(b);
  }

  static std::int64_t end(const std::vector<Lease>& leases) {
    std::int64_t result = 0;
    for (const Lease& one : leases) result = std::max(result, one.place + one.values);
    return result;
  }

  // Each at the first place that is free for as long as it is needed.
  void place_in_turn() {
    for (auto lease = moving_.begin(); lease != moving_.end(); ++lease) {
      std::vector<Lease> beside;
      const auto keep = [&](const Lease& one) { return one.is_beside(*lease); };
      std::copy_if(fixed_.begin(), fixed_.end(), std::back_inserter(beside), keep);
      std::copy_if(moving_.begin(), lease, std::back_inserter(beside), keep);
      lease->place = first_gap(beside, lease->values);
    }
  }

  static std::int64_t first_gap(std::vector<Lease>& taken, std::int64_t values) {
    std::sort(taken.begin(), taken.end(), [](const Lease& a, const Lease& b) { return a.place < b.place; });
    std::int64_t place = 0;
    for (const Lease& one : taken) {
      if (one.place - place >= values) break;
      place = std::max(place, one.place + one.values);
    }
    return place;
  }

  void add_waits(const Lease& one, int unit, Storage& storage) const {
    if (one.unit >= 0) return add_wait(schedule_.unit[one.unit].parent, unit, storage);
    for (const int subtree : schedule_.subtree) add_wait(subtree, unit, storage);
  }

  // What is below a unit is done before it anyway, and so is everything before what all threads do.
  void add_wait(int done, int unit, Storage& storage) const {
    if (schedule_.unit[unit].flops > storage.alone || (first_below_[unit] <= done && done < unit)) return;
    storage.waits.emplace_back(done, unit);
  }

  const Schedule& schedule_;
  int units_ = 0;
  std::vector<int> first_below_;  // of every unit: the first one of its subtree
  std::vector<Lease> fixed_, moving_;
};

}  // namespace

Storage::Storage(const Structure& structure, const Schedule& schedule, int most_threads)
    : threads(std::clamp(leaves(schedule), 1, most_threads)),
      alone(std::max(is_alone_to * schedule.flops / most_threads, schedule.most_of_subtree)) {
  const std::vector<Times> times = Simulation(schedule, threads, alone).times();
  Planner planner(structure, schedule, times, threads);
  planner.place();
  planner.write(*this);
}

}  // namespace isostretch::cholesky
