#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace isostretch::mesh {

// What a file says of an element besides its nodes.
struct ElementLabel {
  std::int64_t number = 0;  // its own; 0: none
  std::int64_t entity = 0;  // what it is a part of
  std::vector<std::int64_t> groups;
};

// Labels of the elements of one list, in order.
class ElementLabels {
 public:
  void add(const ElementLabel& label);

  // Compares two elements by their nodes: below 0, 0, above 0.
  using Compare = std::function<int(int, int)>;

  // Marks with 0 every element that is a copy of an earlier one: the same number, or, if `for_groups`, the
  // same nodes and entity for another group. Groups of a copy become those of the first. A `fault` is an
  // element number given to different elements.
  std::vector<char> drop_copies(const Compare& compare, bool for_groups, std::string& fault);

  // Elements by group.
  const std::vector<std::pair<std::int64_t, int>>& groups() const { return groups_; }

 private:
  void mark(const Compare& compare, std::vector<int>& original, std::string& fault) const;
  void mark_for_groups(const Compare& compare, std::vector<int>& original) const;
  std::vector<char> keep_originals(const std::vector<int>& original);

  std::size_t count_ = 0;
  std::vector<std::int64_t> numbers_, entities_;      // empty until an element has a label
  std::vector<std::pair<std::int64_t, int>> groups_;  // number and element
};

}  // namespace isostretch::mesh
