#include <isostretch/core/error.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/handles/selection.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <queue>
#include <utility>

namespace isostretch::handles {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class Selector {
 public:
  Selector(const Nodes& nodes, const std::string& name) : nodes_(nodes), name_(name) {}

  std::vector<int> operator()(const All&) const {
    return where([](const Point&) { return true; });
  }

  std::vector<int> operator()(const Box& box) const {
    for (int i = 0; i < nodes_.dim; ++i)
      if (!(box.low[i] <= box.high[i])) fail("the box is empty along axis " + std::to_string(i));
    return where([&](const Point& p) {
      for (int i = 0; i < nodes_.dim; ++i)
        if (!(box.low[i] <= p[i] && p[i] <= box.high[i])) return false;
      return true;
    });
  }

  std::vector<int> operator()(const Sphere& sphere) const {
    require_positive(sphere.radius, "radius");
    return where([&](const Point& p) { return distance(p, sphere.center) <= sphere.radius; });
  }

  std::vector<int> operator()(const List& list) const {
    for (const int node : list.nodes)
      if (node < 0 || node >= nodes_.count())
        fail("there is no vertex " + std::to_string(node) + ", they go from 0 to " +
             std::to_string(nodes_.count() - 1));
    std::vector<int> chosen;
    std::copy_if(list.nodes.begin(), list.nodes.end(), std::back_inserter(chosen),
                 [this](int node) { return nodes_.counts(node); });
    if (chosen.empty() && !list.nodes.empty())
      fail("selects no vertex of an element: vertex " + std::to_string(list.nodes.front()) +
           " belongs to none");
    return chosen;
  }

  std::vector<int> operator()(const Group& group) const {
    const std::vector<int>& nodes = nodes_.groups[find_group(group.name, nodes_.groups, name_)].nodes;
    std::vector<int> chosen;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(chosen),
                 [this](int node) { return nodes_.counts(node); });
    return chosen;
  }

  std::vector<int> operator()(const Slab& slab) const {
    if (slab.axis < 0 || slab.axis >= nodes_.dim)
      fail("axis " + std::to_string(slab.axis) + " in " + std::to_string(nodes_.dim) + "D");
    require_positive(slab.width, "width");
    double low = infinity, high = -infinity;
    for (int n = 0; n < nodes_.count(); ++n) {
      if (!nodes_.counts(n)) continue;
      low = std::min(low, nodes_.at(n)[slab.axis]);
      high = std::max(high, nodes_.at(n)[slab.axis]);
    }
    const double width = slab.relative ? slab.width * (high - low) : slab.width;
    return where([&](const Point& p) {
      return slab.end == End::min ? p[slab.axis] - low <= width : high - p[slab.axis] <= width;
    });
  }

  std::vector<int> operator()(const Nearest& nearest) const {
    if (nearest.count < 1) fail("a count of " + std::to_string(nearest.count) + ", must be at least 1");
    std::vector<int> order = where([](const Point&) { return true; });
    if (nearest.count > std::ssize(order))
      fail("the " + std::to_string(nearest.count) + " nearest of " + std::to_string(order.size()) +
           " vertices");
    const auto nearer = [&](int a, int b) {
      return std::pair(distance(nodes_.at(a), nearest.point), a) <
             std::pair(distance(nodes_.at(b), nearest.point), b);
    };
    std::partial_sort(order.begin(), order.begin() + nearest.count, order.end(), nearer);
    order.resize(static_cast<std::size_t>(nearest.count));
    return order;
  }

  std::vector<int> operator()(const Patch& patch) const {
    if (!(patch.distance >= 0)) fail("a distance of " + to_text(patch.distance));
    if (nodes_.boundary_edges.empty()) fail("a patch, and the boundary has no edges");
    const std::vector<double> distances = distances_from(nearest_on_boundary(patch.point), patch.distance);
    std::vector<int> chosen;
    for (std::size_t n = 0; n < distances.size(); ++n)
      if (distances[n] <= patch.distance) chosen.push_back(static_cast<int>(n));
    return chosen;
  }

  std::vector<int> operator()(const Segment& segment) const {
    require_positive(segment.distance, "distance");
    if (!segment.from.allFinite() || !segment.to.allFinite()) fail("a point that is not finite");
    return where([&](const Point& p) { return distance(p, nearest_on(segment, p)) <= segment.distance; });
  }

  [[noreturn]] void fail(const std::string& what) const { throw Error(name_ + ": " + what); }

 private:
  template <class Inside>
  std::vector<int> where(const Inside& inside) const {
    std::vector<int> chosen;
    for (int n = 0; n < nodes_.count(); ++n)
      if (nodes_.counts(n) && inside(nodes_.at(n))) chosen.push_back(n);
    return chosen;
  }

  double distance(const Point& a, const Point& b) const {
    double sum = 0;
    for (int i = 0; i < nodes_.dim; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
  }

  Point nearest_on(const Segment& segment, const Point& p) const {
    double along = 0, squared = 0;
    for (int i = 0; i < nodes_.dim; ++i) {
      const double d = segment.to[i] - segment.from[i];
      along += d * (p[i] - segment.from[i]);
      squared += d * d;
    }
    const double share = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
    return segment.from + share * (segment.to - segment.from);
  }

  void require_positive(double value, const char* what) const {
    if (!(value > 0)) fail(std::string("a ") + what + " of " + to_text(value) + ", must be positive");
  }

  int nearest_on_boundary(const Point& point) const {
    std::pair<double, int> best{infinity, -1};
    for (const auto& edge : nodes_.boundary_edges)
      for (const int n : edge) best = std::min(best, std::pair(distance(nodes_.at(n), point), n));
    if (best.second < 0) fail("a point that is not finite");
    return best.second;
  }

  // Dijkstra's algorithm, as far as `limit`.
  std::vector<double> distances_from(int start, double limit) const {
    const std::vector<std::vector<int>> neighbours = boundary_neighbours();
    std::vector<double> distances(static_cast<std::size_t>(nodes_.count()), infinity);
    std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> front;
    distances[static_cast<std::size_t>(start)] = 0;
    front.emplace(0.0, start);
    while (!front.empty()) {
      const auto [so_far, node] = front.top();
      front.pop();
      if (so_far > distances[static_cast<std::size_t>(node)] || so_far > limit) continue;
      for (const int next : neighbours[static_cast<std::size_t>(node)]) {
        const double longer = so_far + distance(nodes_.at(node), nodes_.at(next));
        if (longer >= distances[static_cast<std::size_t>(next)]) continue;
        distances[static_cast<std::size_t>(next)] = longer;
        front.emplace(longer, next);
      }
    }
    return distances;
  }

  std::vector<std::vector<int>> boundary_neighbours() const {
    std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(nodes_.count()));
    for (const auto& [a, b] : nodes_.boundary_edges) {
      neighbours[static_cast<std::size_t>(a)].push_back(b);
      neighbours[static_cast<std::size_t>(b)].push_back(a);
    }
    return neighbours;
  }

  const Nodes& nodes_;
  const std::string& name_;
};

}  // namespace

std::size_t find_group(const std::string& wanted, const std::vector<NodeGroup>& groups,
                       const std::string& name) {
  const auto called = [&](const auto& of) {
    return static_cast<std::size_t>(
        std::find_if(groups.begin(), groups.end(), [&](const NodeGroup& g) { return of(g) == wanted; }) -
        groups.begin());
  };
  std::size_t found = called([](const NodeGroup& g) { return g.name; });
  if (found == groups.size() || wanted.empty())
    found = called([](const NodeGroup& g) { return std::to_string(g.number); });
  if (found < groups.size()) return found;
  std::string text;
  for (const NodeGroup& g : groups)
    text +=
        (text.empty() ? "" : ", ") + std::to_string(g.number) + (g.name.empty() ? "" : " '" + g.name + "'");
  throw Error(name + ": there is no group '" + wanted + "'; " +
              (text.empty() ? "the mesh has none" : "there are " + text));
}

std::vector<int> select(const Selection& selection, const Nodes& nodes, const std::string& name) {
  const Selector selector(nodes, name);
  std::vector<int> chosen = std::visit(selector, selection);
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  if (chosen.empty()) selector.fail("selects no vertex");
  return chosen;
}

}  // namespace isostretch::handles
