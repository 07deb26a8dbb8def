#include "element_labels.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

namespace isostretch::mesh {

void ElementLabels::add(const ElementLabel& label) {
  const int element = static_cast<int>(count_++);
  if (numbers_.empty() && label.number == 0 && label.groups.empty()) return;  // nothing said so far
  numbers_.resize(static_cast<std::size_t>(element));
  entities_.resize(static_cast<std::size_t>(element));
  numbers_.push_back(label.number);
  entities_.push_back(label.entity);
  for (const std::int64_t group : label.groups) groups_.emplace_back(group, element);
}

std::vector<char> ElementLabels::drop_copies(const Compare& compare, bool for_groups, std::string& fault) {
  if (numbers_.empty()) return std::vector<char>(count_, 1);
  std::vector<int> original(count_);
  std::iota(original.begin(), original.end(), 0);
  mark(compare, original, fault);
  if (for_groups) mark_for_groups(compare, original);
  return keep_originals(original);
}

// By number. Numbers rise as a rule, and then none is there twice; most formats have none.
void ElementLabels::mark(const Compare& compare, std::vector<int>& original, std::string& fault) const {
  const bool rising =
      std::adjacent_find(numbers_.begin(), numbers_.end(), std::greater_equal<>()) == numbers_.end();
  if (rising || std::count(numbers_.begin(), numbers_.end(), 0) == std::ssize(numbers_)) return;
  const auto number = [this](int e) { return numbers_[static_cast<std::size_t>(e)]; };
  std::vector<int> order = original;
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return number(a) < number(b); });
  for (std::size_t i = 1, first = 0; i < order.size(); ++i) {
    if (number(order[i]) != number(order[first])) first = i;
    if (first == i || number(order[i]) == 0) continue;
    if (compare(order[i], order[first]) == 0)
      original[static_cast<std::size_t>(order[i])] = order[first];
    else if (fault.empty())
      fault = "element " + std::to_string(number(order[i])) + " for the second time, with other vertices";
  }
}

void ElementLabels::mark_for_groups(const Compare& compare, std::vector<int>& original) const {
  std::vector<std::vector<std::int64_t>> groups_of(numbers_.size());
  for (const auto& [group, element] : groups_) groups_of[static_cast<std::size_t>(element)].push_back(group);
  const auto entity = [this](int e) { return entities_[static_cast<std::size_t>(e)]; };
  std::vector<int> order(numbers_.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    const int nodes = compare(a, b);
    return nodes != 0 ? nodes < 0 : entity(a) < entity(b);
  });
  std::set<std::int64_t> seen;  // groups of the first and its copies so far
  for (std::size_t i = 0, first = 0; i < order.size(); ++i) {
    const auto& own = groups_of[static_cast<std::size_t>(order[i])];
    if (i > 0 && (entity(order[i]) != entity(order[first]) || compare(order[i], order[first]) != 0))
      first = i;
    if (first == i) seen.clear();
    const bool other = !own.empty() && std::none_of(own.begin(), own.end(), [&](std::int64_t group) {
      return seen.count(group) > 0;
    });
    if (first != i && other && !seen.empty() && original[static_cast<std::size_t>(order[i])] == order[i])
      original[static_cast<std::size_t>(order[i])] = order[first];
    seen.insert(own.begin(), own.end());
  }
}

std::vector<char> ElementLabels::keep_originals(const std::vector<int>& original) {
  std::vector<char> keep(original.size(), 0);
  std::vector<int> number(original.size(), -1);
  int next = 0;
  for (std::size_t e = 0; e < original.size(); ++e) {
    keep[e] = original[e] == static_cast<int>(e);
    if (keep[e]) number[e] = next++;
  }
  // A copy of a copy has its group's place by the first of all.
  const auto first = [&](int e) {
    while (original[static_cast<std::size_t>(e)] != e) e = original[static_cast<std::size_t>(e)];
    return number[static_cast<std::size_t>(e)];
  };
  for (auto& [group, element] : groups_) element = first(element);
  std::sort(groups_.begin(), groups_.end());
  groups_.erase(std::unique(groups_.begin(), groups_.end()), groups_.end());
  return keep;
}

}  // namespace isostretch::mesh
