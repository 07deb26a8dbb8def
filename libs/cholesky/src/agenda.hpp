#pragma once

#include "schedule.hpp"
#include "storage.hpp"

#include <cstddef>
#include <mutex>
#include <vector>

namespace isostretch::cholesky {

// Hands the units of a schedule to threads, those with the longest path to the root first. Takes no memory
// after reserve().
class Agenda {
 public:
  void reserve(std::size_t units);

  // All units that are the work of single threads; `again`: only those that change.
  void begin(const Schedule& schedule, const Storage& storage, bool again);
  // Number of a unit that has nothing to wait for, as soon as there is one; -1: all are taken.
  int take();
  void finish(int unit);

 private:
  bool is_due(int unit) const;
  void release(int unit);

  const Schedule* schedule_ = nullptr;
  const Storage* storage_ = nullptr;
  std::mutex mutex_;
  std::vector<int> ready_;    // heap
  std::vector<int> waiting_;  // of every unit: those that it waits for and are not done
  int open_ = 0;              // units that nobody has taken
  bool again_ = false;
};

}  // namespace isostretch::cholesky
