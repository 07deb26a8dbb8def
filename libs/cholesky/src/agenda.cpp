#include "agenda.hpp"

#include <algorithm>
#include <thread>
#include <utility>

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

void Agenda::begin(const Schedule& schedule, const Storage& storage, bool again) {
  schedule_ = &schedule;
  storage_ = &storage;
  again_ = again;
  ready_.clear();
  waiting_.assign(schedule.unit.size(), 1);
  open_ = 0;
  const int count = static_cast<int>(schedule.unit.size());
  for (int u = 0; u < count; ++u) {
    if (!is_due(u)) continue;
    if (schedule.unit[u].flops <= storage.alone) ++open_;
    if (const int parent = schedule.unit[u].parent; parent >= 0) ++waiting_[parent];
  }
  for (const auto& [done, unit] : storage.waits)
    if (is_due(done)) ++waiting_[unit];
  for (int u = 0; u < count; ++u)
    if (is_due(u)) release(u);
}

bool Agenda::is_due(int unit) const {
  return !again_ || schedule_->unit[unit].changes;
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
  if (const int parent = schedule_->unit[unit].parent; parent >= 0) release(parent);
  const auto& waits = storage_->waits;
  for (auto wait = std::lower_bound(waits.begin(), waits.end(), std::pair(unit, 0));
       wait != waits.end() && wait->first == unit; ++wait)
    if (is_due(wait->second)) release(wait->second);
}

// One of those that the unit waits for is done.
void Agenda::release(int unit) {
  if (--waiting_[unit] > 0 || schedule_->unit[unit].flops > storage_->alone) return;
  ready_.push_back(unit);
  std::push_heap(ready_.begin(), ready_.end(), ShorterPath{schedule_});
}

}  // namespace isostretch::cholesky
