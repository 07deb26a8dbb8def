// Places of update matrices: nothing overlaps that is needed at the same time, in any order that units may
// take.
#include "../src/storage.hpp"

#include "matrices.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <utility>
#include <vector>

using namespace isostretch::cholesky;
using namespace isostretch::cholesky::test;

namespace {

// What is in use, by its first value.
class Memory {
 public:
  void take(std::int64_t place, std::int64_t values) {
    if (values == 0) return;
    const auto next = used_.lower_bound(place);
    const bool free = (next == used_.end() || place + values <= next->first) &&
                      (next == used_.begin() || std::prev(next)->first + std::prev(next)->second <= place);
    REQUIRE(free);
    used_[place] = values;
  }
  void give_back(std::int64_t place, std::int64_t values) {
    if (values > 0) REQUIRE(used_.erase(place) == 1);
  }

 private:
  std::map<std::int64_t, std::int64_t> used_;
};

// Eliminates units in an order drawn at random, as threads of any speed would.
class Execution {
 public:
  Execution(const Structure& structure, const Schedule& schedule, const Storage& storage, int threads,
            unsigned seed)
      : structure_(structure), schedule_(schedule), storage_(storage), slots_(threads, -1), random_(seed) {}

  void factorize() {
    eliminate(false);
    eliminate(true);
  }

 private:
  int count() const { return static_cast<int>(schedule_.unit.size()); }
  bool is_due(int u, bool again) const { return !again || schedule_.unit[u].changes; }

  void eliminate(bool again) {
    std::vector<int> waiting(schedule_.unit.size(), 0), ready;
    for (int u = 0; u < count(); ++u)
      if (is_due(u, again) && schedule_.unit[u].parent >= 0) ++waiting[schedule_.unit[u].parent];
    for (const auto& [done, unit] : storage_.waits)
      if (is_due(done, again)) ++waiting[unit];
    const auto is_shared = [&](int u) {
      return schedule_.unit[u].is_top && schedule_.unit[u].flops > storage_.alone;
    };
    int left = 0;
    for (int u = 0; u < count(); ++u) {
      if (again && is_due(u, again)) memory_.give_back(columns(u).first, columns(u).second);
      if (!is_due(u, again) || is_shared(u)) continue;
      ++left;
      if (waiting[u] == 0) ready.push_back(u);
    }
    while (left > 0) {
      const std::size_t slot = random_() % slots_.size();
      if (slots_[slot] < 0) {
        if (ready.empty()) continue;
        std::swap(ready[random_() % ready.size()], ready.back());
        slots_[slot] = ready.back();
        ready.pop_back();
        begin(slots_[slot], slot);
        continue;
      }
      const int u = std::exchange(slots_[slot], -1);
      end(u, slot, again);
      --left;
      const auto release = [&](int unit) {
        if (is_due(unit, again) && --waiting[unit] == 0 && !is_shared(unit)) ready.push_back(unit);
      };
      if (schedule_.unit[u].parent >= 0) release(schedule_.unit[u].parent);
      for (const auto& [done, unit] : storage_.waits)
        if (done == u) release(unit);
    }
    for (int u = 0; u < count(); ++u)
      if (is_due(u, again) && is_shared(u)) {
        begin(u, 0);
        end(u, 0, again);
      }
  }

  std::pair<std::int64_t, std::int64_t> columns(int u) const {
    const std::int64_t begin = structure_.supernode[schedule_.unit[u].begin].values;
    return {begin, structure_.supernode[schedule_.unit[u].root + 1].values - begin};
  }
  std::int64_t update(int u) const {
    const Unit& unit = schedule_.unit[u];
    return unit.parent < 0 ? 0 : update_values(structure_.supernode[unit.root]);
  }

  void begin(int u, std::size_t slot) {
    memory_.take(columns(u).first, columns(u).second);
    memory_.take(storage_.update[u], update(u));
    if (!schedule_.unit[u].is_top) memory_.take(storage_.stack[slot], schedule_.stack);
  }

  // Children that do not change are kept for refactorizations of the parent.
  void end(int u, std::size_t slot, bool again) {
    if (!schedule_.unit[u].is_top) memory_.give_back(storage_.stack[slot], schedule_.stack);
    for (int c = 0; c < count(); ++c)
      if (schedule_.unit[c].parent == u && is_due(c, again) &&
          (schedule_.unit[c].changes || !schedule_.unit[u].changes))
        memory_.give_back(storage_.update[c], update(c));
  }

  const Structure& structure_;
  const Schedule& schedule_;
  const Storage& storage_;
  std::vector<int> slots_;  // unit of every thread; -1: none
  Memory memory_;
  std::mt19937 random_;
};

}  // namespace

TEST_CASE("storage: nothing overlaps that is needed at the same time, whatever the order of units") {
  const Matrix meshes[] = {grid(34, 31, 2), grid(200, 4, 1), random_matrix(700, 0.01, 3),
                           random_matrix(50, 0, 1)};
  for (const Matrix& A : meshes)
    for (const int last : {0, 1, 30, 50}) {
      const Analysis analysis(A.pattern(), shuffled(A.size, 8), {}, last);
      const Schedule schedule(analysis.structure());
      for (const int threads : {1, 2, 3, 8, 200}) {
        const Storage storage(analysis.structure(), schedule, threads);
        CHECK(storage.values >= analysis.structure().values);
        for (unsigned seed = 0; seed < 4; ++seed)
          Execution(analysis.structure(), schedule, storage, storage.threads, seed).factorize();
      }
    }
}

TEST_CASE("storage: threads that can never be at work have no stack, and units are few in any tree") {
  for (const Matrix& A : {arrowhead(5000), grid(2, 1500, 1), grid(34, 31, 2), repeated(grid(3, 3, 1), 300)}) {
    const Analysis analysis(A.pattern());
    const Schedule schedule(analysis.structure());
    int moving = 0, leaves = 0;
    for (const Unit& unit : schedule.unit) {
      moving += unit.parent >= 0;
      leaves += unit.children == 0;
      CHECK((unit.is_top || unit.flops <= schedule.most_of_subtree));
    }
    CHECK(moving <= 256);
    const Storage storage(analysis.structure(), schedule, 1000);
    CHECK(storage.threads <= leaves);
    CHECK(storage.stack.size() == static_cast<std::size_t>(storage.threads));
  }
}

TEST_CASE("storage: little is taken besides L") {
  const Matrix A = grid(34, 31, 2);
  const Analysis analysis(A.pattern(), shuffled(A.size, 8));
  const Schedule schedule(analysis.structure());
  std::int64_t all = 0;
  for (const Unit& unit : schedule.unit)
    if (unit.parent >= 0) all += update_values(analysis.structure().supernode[unit.root]);
  const Storage storage(analysis.structure(), schedule, 2);
  CHECK(storage.values - analysis.structure().values < all / 2);
}
