#pragma once

#include "box_tree.hpp"

#include <cstddef>
#include <vector>

namespace isostretch::mesh {

// A place on a segment.
struct Mark {
  double along = 0;  // from 0 to 1
  PlanePoint point{};
};

// Part of a segment.
struct Interval {
  Mark begin, end;
};

// Under how many triangles the places of an interval lie, where it makes no difference whether there are two
// or more. That takes memory for what lies under fewer, however many triangles there are.
class Depth {
 public:
  explicit Depth(const Interval& whole);

  // `count` triangles lie over a part of the segment.
  void add(Interval part, double count);

  // Holds what lay under fewer than two when it was last joined; triangles elsewhere make no difference.
  const PlaneBox& open() const { return open_; }

  // Brings what was added into order.
  void join();

  // Calls visit(begin, end, depth) for one part after the other, which make up the whole; to be joined first.
  template <class Visit>
  void for_each_part(const Visit& visit) const {
    double depth = 0;
    PlanePoint from = whole_.begin.point;
    for (const Change& change : changes_) {
      visit(from, change.where.point, depth);
      from = change.where.point;
      depth += change.by;
    }
    visit(from, whole_.end.point, depth);
  }

 private:
  struct Change {
    Mark where;
    double by = 0;
  };

  void find_open();

  Interval whole_;
  std::vector<Change> changes_;
  std::size_t limit_ = 8;  // changes that are joined at once
  PlaneBox open_;
};

}  // namespace isostretch::mesh
