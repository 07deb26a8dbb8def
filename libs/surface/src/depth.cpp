#include "depth.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace isostretch::mesh {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Meets no other.
constexpr PlaneBox nothing{{infinity, infinity}, {-infinity, -infinity}};

}  // namespace

Depth::Depth(const Interval& whole) : whole_(whole) {
  find_open();
}

void Depth::add(Interval part, double count) {
  if (part.begin.along < whole_.begin.along) part.begin = whole_.begin;
  if (part.end.along > whole_.end.along) part.end = whole_.end;
  if (!(part.begin.along < part.end.along)) return;
  changes_.push_back({part.begin, count});
  changes_.push_back({part.end, -count});
  if (changes_.size() >= limit_) join();
}

// Changes at one place become one, and the depth after each is 0, 1 or 2.
void Depth::join() {
  std::sort(changes_.begin(), changes_.end(),
            [](const Change& a, const Change& b) { return a.where.along < b.where.along; });
  std::vector<Change> joined;
  double depth = 0, before = 0;  // all of it, and up to two
  for (std::size_t i = 0, end = 0; i < changes_.size(); i = end) {
    for (; end < changes_.size() && changes_[end].where.along == changes_[i].where.along; ++end)
      depth += changes_[end].by;
    const double now = std::min(depth, 2.0);
    if (now != before) joined.push_back({changes_[i].where, now - before});
    before = now;
  }
  changes_ = std::move(joined);
  limit_ = std::max(limit_, 2 * changes_.size());
  find_open();
}

void Depth::find_open() {
  open_ = nothing;
  double depth = 0;
  Mark from = whole_.begin;
  const auto advance = [&](const Mark& to) {
    if (depth < 2 && from.along < to.along)
      for (const PlanePoint& p : {from.point, to.point}) open_.include({p, p});
    from = to;
  };
  for (const Change& change : changes_) {
    advance(change.where);
    depth += change.by;
  }
  advance(whole_.end);
}

}  // namespace isostretch::mesh
