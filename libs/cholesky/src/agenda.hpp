#pragma once

#include "schedule.hpp"

#include <cstddef>
#include <mutex>
#include <vector>

namespace isostretch::cholesky {

// Hands the units of a schedule to threads, those with the longest path to the root first. Takes no memory
// after reserve().
class Agenda {
 public:
  void reserve(std::size_t units);

  // All units of at most so many operations with what is below them.
  void begin(const Schedule& schedule, double most_flops);
  // Number of a unit whose children are done, as soon as there is one; -1: there is none left to wait for.
  int take();
  void finish(int unit);

 private:
  void offer(int unit);

  const Schedule* schedule_ = nullptr;
  std::mutex mutex_;
  std::vector<int> ready_;    // heap
  std::vector<int> waiting_;  // of every unit: children that are not done
  int open_ = 0;              // units that nobody has taken
  double most_flops_ = 0;
};

}  // namespace isostretch::cholesky
