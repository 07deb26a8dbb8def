#include <isostretch/handles/elements.hpp>

#include <algorithm>

namespace isostretch::handles {

std::vector<int> elements_within(const std::vector<int>& chosen, const assembly::Elements& elements) {
  std::vector<bool> is_chosen(static_cast<std::size_t>(elements.node_count), false);
  for (const int node : chosen) is_chosen[static_cast<std::size_t>(node)] = true;
  const auto k = static_cast<std::size_t>(elements.nodes_per_element);
  std::vector<int> result;
  for (std::size_t e = 0; e < elements.nodes.size() / k; ++e)
    if (std::all_of(elements.nodes.begin() + static_cast<std::ptrdiff_t>(e * k),
                    elements.nodes.begin() + static_cast<std::ptrdiff_t>((e + 1) * k),
                    [&](int node) { return is_chosen[static_cast<std::size_t>(node)]; }))
      result.push_back(static_cast<int>(e));
  return result;
}

assembly::Elements restricted(const assembly::Elements& elements, const std::vector<int>& chosen) {
  assembly::Elements part = elements;
  part.nodes.clear(), part.gradients.clear(), part.weights.clear();
  const auto copy = [&](const auto& from, auto& to, std::size_t per_element) {
    for (const int e : chosen) {
      const auto start =
          from.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(e) * per_element);
      to.insert(to.end(), start, start + static_cast<std::ptrdiff_t>(per_element));
    }
  };
  const auto nodes = static_cast<std::size_t>(elements.nodes_per_element),
             points = static_cast<std::size_t>(elements.points_per_element);
  copy(elements.nodes, part.nodes, nodes);
  copy(elements.gradients, part.gradients, points * nodes * static_cast<std::size_t>(elements.dim));
  copy(elements.weights, part.weights, points);
  return part;
}

}  // namespace isostretch::handles
