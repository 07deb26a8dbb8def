#include "bounded_minimum.hpp"
#include "free_system.hpp"
#include "stiffness.hpp"

#include <isostretch/assembly/operators.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/index.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/handles/bounded_weights.hpp>
#include <isostretch/handles/elements.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>

namespace isostretch::handles {
namespace {

constexpr int none = -1, several = -2;

std::string handle_name(int h) {
  return "weights: handle " + std::to_string(h);
}

// The handle of every node, or none.
std::vector<int> owners(int node_count, const std::vector<std::vector<int>>& handles) {
  if (handles.empty()) throw Error("weights: there are no handles");
  std::vector<int> owner(at(node_count), none);
  for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
    if (handles[at(h)].empty()) throw Error(handle_name(h) + " has no nodes");
    for (const int n : handles[at(h)]) {
      if (n < 0 || n >= node_count)
        throw Error(handle_name(h) + ": there is no node " + std::to_string(n) + ", there are " +
                    std::to_string(node_count));
      if (owner[at(n)] != none && owner[at(n)] != h)
        throw Error(handle_name(h) + ": node " + std::to_string(n) + " belongs to handle " +
                    std::to_string(owner[at(n)]) + " already");
      owner[at(n)] = h;
    }
  }
  return owner;
}

// The only handle that reaches a component, or none, or several of them.
std::vector<int> reached_by(const std::vector<int>& component, const std::vector<int>& owner) {
  const int count = 1 + *std::max_element(component.begin(), component.end());
  std::vector<int> reached(at(count), none);
  for (std::size_t n = 0; n < owner.size(); ++n) {
    if (owner[n] == none || component[n] < 0) continue;
    int& by = reached[at(component[n])];
    by = by == none || by == owner[n] ? owner[n] : several;
  }
  return reached;
}

// Components that each handle reaches together with others: elsewhere there is nothing to solve.
std::vector<bool> shared_by(int handle, const std::vector<int>& component, const std::vector<int>& reached,
                            const std::vector<int>& owner) {
  std::vector<bool> shared(reached.size(), false);
  for (std::size_t n = 0; n < owner.size(); ++n)
    if (owner[n] == handle && component[n] >= 0)
      shared[at(component[n])] = reached[at(component[n])] == several;
  return shared;
}

// Divides by the sum: the approximation of the paper.
void normalize_rows(HandleWeights& weights) {
  const std::size_t count = at(weights.handles);
  for (std::size_t n = 0; n < weights.values.size() / count; ++n) {
    double sum = 0;
    for (std::size_t h = 0; h < count; ++h) sum += weights.values[n * count + h];
    if (!(sum > 1e-6)) throw Error("weights: no handle has a weight at node " + std::to_string(n));
    for (std::size_t h = 0; h < count; ++h) weights.values[n * count + h] /= sum;
  }
}

}  // namespace

void WeightOptions::validate() const {
  if (!(tolerance >= 1e-12 && tolerance <= 1e-3))
    throw Error("weights: tolerance " + to_text(tolerance) + " is not between 1e-12 and 1e-3");
  if (max_iterations < 1)
    throw Error("weights: max_iterations is " + std::to_string(max_iterations) + ", must be at least 1");
}

HandleWeights bounded_biharmonic_weights(const assembly::Elements& elements,
                                         const std::vector<std::vector<int>>& handles,
                                         const WeightOptions& options) {
  elements.validate();
  options.validate();
  const std::vector<int> owner = owners(elements.node_count, handles);
  const std::vector<int> component = component_of_nodes(elements);
  const std::vector<int> reached = reached_by(component, owner);
  const std::size_t nodes = owner.size(), count = handles.size();

  HandleWeights result;
  result.handles = static_cast<int>(count);
  result.values.assign(nodes * count, 0.0);
  result.reports.resize(count);
  std::vector<bool> unknown(nodes, false);
  for (std::size_t n = 0; n < nodes; ++n) {
    const int by = owner[n] != none ? owner[n] : component[n] < 0 ? none : reached[at(component[n])];
    if (by == several) {
      unknown[n] = true;
      continue;
    }
    if (by == none) result.unreached.push_back(static_cast<int>(n));
    result.values[n * count + at(std::max(by, 0))] = 1;
  }

  const Rows stiffness = stiffness_rows(elements);
  const Rows both = squared(stiffness, assembly::operators::lumped_mass(elements));
  const FreeSystem free_system(stiffness, both, elements.dim, options.solver);
  const Relaxation relaxation(both);
  const WeightSystem system{relaxation, free_system};
  std::vector<double> start(nodes * count, 0.0);
  for (std::size_t n = 0; n < nodes; ++n)
    if (owner[n] != none) start[at(owner[n]) * nodes + n] = 1;
  free_system.solve(unknown, start, result.handles);  // without bounds one system for all

  // Handles do not know of each other: a thread each. Exceptions must not leave the loop.
  std::vector<std::exception_ptr> errors(count);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t h = 0; h < count; ++h) {
    try {
      const int handle = static_cast<int>(h);
      const std::vector<bool> shared = shared_by(handle, component, reached, owner);
      std::vector<int> wanted;
      for (std::size_t n = 0; n < nodes; ++n)
        if (unknown[n] && shared[at(component[n])]) wanted.push_back(static_cast<int>(n));
      const auto first = start.begin() + static_cast<std::ptrdiff_t>(h * nodes);
      std::vector<double> w(first, first + static_cast<std::ptrdiff_t>(nodes));
      result.reports[h] = minimize_bounded(system, wanted, options, handle_name(handle), w);
      for (const int n : wanted) result.values[at(n) * count + h] = w[at(n)];
    } catch (...) {
      errors[h] = std::current_exception();
    }
  }
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
  normalize_rows(result);
  return result;
}

}  // namespace isostretch::handles
