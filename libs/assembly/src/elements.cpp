#include <isostretch/assembly/elements.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/to_text.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace isostretch::assembly {
namespace {

std::string element_name(std::size_t element) {
  return "element " + std::to_string(element);
}

void require_sizes(const Elements& e) {
  if (e.dim != 2 && e.dim != 3) throw Error("elements of dim " + std::to_string(e.dim) + ": dim is 2 or 3");
  const int n = e.nodes_per_element;
  const bool known = e.dim == 2 ? n == 3 || n == 4 || n == 6 : n == 4 || n == 8 || n == 10;
  if (!known)
    throw Error("elements of " + std::to_string(n) + " nodes in " + std::to_string(e.dim) +
                "D: there are 3, 4 and 6 in 2D, 4, 8 and 10 in 3D");
  if (e.points_per_element < 1) throw Error("elements without quadrature points");
  const std::size_t count = static_cast<std::size_t>(e.element_count());
  if (count == 0) throw Error("there are no elements");
  const std::size_t points = count * static_cast<std::size_t>(e.points_per_element);
  if (e.nodes.size() != count * static_cast<std::size_t>(n))
    throw Error("node array of " + std::to_string(e.nodes.size()) + " entries is not a multiple of " +
                std::to_string(n));
  if (e.weights.size() != points)
    throw Error(std::to_string(e.weights.size()) + " weights for " + std::to_string(points) +
                " quadrature points");
  if (e.gradients.size() != points * static_cast<std::size_t>(n * e.dim))
    throw Error(std::to_string(e.gradients.size()) + " gradient entries for " + std::to_string(points) +
                " quadrature points of " + std::to_string(n) + " nodes");
}

void require_balanced(const Elements& e, std::size_t point, const std::string& name) {
  const double* g = e.gradients.data() + point * static_cast<std::size_t>(e.nodes_per_element * e.dim);
  double largest = 0;
  for (int c = 0; c < e.dim; ++c) {
    double sum = 0;
    for (int a = 0; a < e.nodes_per_element; ++a) {
      const double value = g[a * e.dim + c];
      if (!std::isfinite(value))
        throw Error(name + ": gradient of node " + std::to_string(a) + " is not finite");
      sum += value;
      largest = std::max(largest, std::abs(value));
    }
    if (std::abs(sum) > 1e-9 * largest) throw Error(name + ": gradients do not add up to zero");
  }
}

// Union-find in which the smallest node of a component stands for it.
class Components {
 public:
  explicit Components(int count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }
  void join(int a, int b) {
    a = find(a), b = find(b);
    parent(std::max(a, b)) = std::min(a, b);
  }

 private:
  int& parent(int i) { return parent_[static_cast<std::size_t>(i)]; }

  std::vector<int> parent_;
};

}  // namespace

void Elements::validate() const {
  require_sizes(*this);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i] < 0 || nodes[i] >= node_count)
      throw Error(element_name(i / static_cast<std::size_t>(nodes_per_element)) + ": node " +
                  std::to_string(nodes[i]) + " is not among the " + std::to_string(node_count) +
                  " there are");
  for (std::size_t point = 0; point < weights.size(); ++point) {
    const std::string name = element_name(point / static_cast<std::size_t>(points_per_element));
    if (!(weights[point] > 0) || !std::isfinite(weights[point]))
      throw Error(name + ": weight " + to_text(weights[point]) + " is not positive and finite");
    require_balanced(*this, point, name);
  }
}

std::vector<int> component_of_nodes(const Elements& elements) {
  Components components(elements.node_count);
  std::vector<int> result(static_cast<std::size_t>(elements.node_count), -1);
  const auto k = static_cast<std::size_t>(elements.nodes_per_element);
  for (std::size_t i = 0; i < elements.nodes.size(); ++i) {
    components.join(elements.nodes[i], elements.nodes[i - i % k]);
    result[static_cast<std::size_t>(elements.nodes[i])] = 0;
  }
  int count = 0;
  for (std::size_t node = 0; node < result.size(); ++node) {
    if (result[node] < 0) continue;
    const auto first = static_cast<std::size_t>(components.find(static_cast<int>(node)));
    result[node] = first == node ? count++ : result[first];
  }
  return result;
}

}  // namespace isostretch::assembly
