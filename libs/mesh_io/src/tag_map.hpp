#pragma once

#include <cstdint>
#include <vector>

namespace isostretch::mesh {

// From the tags that a file gives its nodes to their positions. Tags are consecutive as a rule, but need not
// be, nor in order.
class TagMap {
 public:
  void add(std::int64_t tag) { tags_.push_back(tag); }  // of the next node
  std::size_t size() const { return tags_.size(); }

  // To call after the last add(). A position whose tag another one has too, or -1.
  int prepare();
  int find(std::int64_t tag) const;  // position, or -1
  std::int64_t tag(int position) const { return tags_[static_cast<std::size_t>(position)]; }

 private:
  bool consecutive() const;
  int fill_table();
  int sort();

  std::vector<std::int64_t> tags_;
  std::int64_t smallest_ = 0;
  std::uint64_t span_ = 0;  // from the smallest tag to the largest
  bool consecutive_ = false;
  std::vector<int> table_;   // by tag - smallest_, when there are few gaps
  std::vector<int> sorted_;  // positions by tag, when there are many
};

}  // namespace isostretch::mesh
