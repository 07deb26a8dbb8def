#include "agenda.hpp"

#include <algorithm>
#include <thread>

namespace isostretch::cholesky {
namespace {

struct ShorterPath {
  const Schedule* schedule;
  bool operator()(int a, int b) const { return schedule->unit[a].path < schedule->unit[b].path; }
};

}  // namespace

void Agenda::reserve(std::size_t units) {
  ready_.reserve(units);
  waiting_.reserve(units);
}

void Agenda::begin(const Schedule& schedule, double most_flops) {
  schedule_ = &schedule;
  most_flops_ = most_flops;
  ready_.clear();
  waiting_.clear();
  open_ = 0;
  for (const Unit& unit : schedule.unit) {
    waiting_.push_back(unit.children);
    if (unit.flops <= most_flops) ++open_;
  }
  for (std::size_t u = 0; u < schedule.unit.size(); ++u)
    if (waiting_[u] == 0 && schedule.unit[u].flops <= most_flops) offer(static_cast<int>(u));
}

// Threads have little to wait for: what keeps one busy is over in a moment.
int Agenda::take() {
  for (;; std::this_thread::yield()) {
    const std::lock_guard lock(mutex_);
    if (open_ == 0) return -1;
    if (ready_.empty()) continue;
    std::pop_heap(ready_.begin(), ready_.end(), ShorterPath{schedule_});
    const int unit = ready_.back();
    ready_.pop_back();
    --open_;
    return unit;
  }
}

void Agenda::finish(int unit) {
  const std::lock_guard lock(mutex_);
  const int parent = schedule_->unit[unit].parent;
  if (parent >= 0 && --waiting_[parent] == 0 && schedule_->unit[parent].flops <= most_flops_) offer(parent);
}

void Agenda::offer(int unit) {
  ready_.push_back(unit);
  std::push_heap(ready_.begin(), ready_.end(), ShorterPath{schedule_});
}

}  // namespace isostretch::cholesky
