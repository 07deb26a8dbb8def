// Total lifted content (Du, Aigerman, Zhou, Kovalsky, Yan, Kaufman, Ju 2020): the sum over elements of
// the content of the element lifted by a share of its rest shape, sqrt(det(F^T F + a I)), which is least
// where no element is inverted, provided that the boundary is held. Hence all targets are held, and instances
// whose boundary is not among them are none for it. Ends at the first map without an inverted element.
#include "formulation.hpp"
#include "registry.hpp"

#include <isostretch/energies/any_energy.hpp>

#include <algorithm>
#include <array>
#include <map>

namespace isostretch::baselines {
namespace {

using Phase = Recorder::Phase;

struct LiftedContent {
  static constexpr const char* name = "lifted_content";
  double lift = 1e-4;  // a: as published

  // det(F^T F + a I) = prod (sigma_i^2 + a).
  template <int Dim, class T>
  T psi(const invariants::Invariants<Dim, T>& I) const {
    using isostretch::invariants::sqrt;
    if constexpr (Dim == 2) {
      return sqrt(I.I3 * I.I3 + lift * I.I2 + lift * lift);
    } else {
      const T pairs = 0.5 * (I.I1 * I.I1 - I.I2);           // sum of sigma_i sigma_j
      const T squares = pairs * pairs - 2.0 * I.I1 * I.I3;  // of their squares
      return sqrt(I.I3 * I.I3 + lift * squares + lift * lift * I.I2 + lift * lift * lift);
    }
  }
};

// Nodes of facets that belong to one element alone.
std::vector<int> boundary_nodes(const assembly::Elements& elements) {
  const auto corners = static_cast<std::size_t>(elements.nodes_per_element);
  std::map<std::vector<int>, int> count;
  const auto each_facet = [&](const auto& visit) {
    for (std::size_t first = 0; first < elements.nodes.size(); first += corners)
      for (std::size_t without = 0; without < corners; ++without) {
        std::vector<int> facet;
        for (std::size_t a = 0; a < corners; ++a)
          if (a != without) facet.push_back(elements.nodes[first + a]);
        std::sort(facet.begin(), facet.end());
        visit(facet);
      }
  };
  each_facet([&](const std::vector<int>& facet) { ++count[facet]; });
  std::vector<int> nodes;
  for (const auto& [facet, elements_there] : count)
    if (elements_there == 1) nodes.insert(nodes.end(), facet.begin(), facet.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

Vector run(const Instance& instance, const Options& options, Recorder& recorder) {
  const sdp_penalty::Problem& problem = instance.problem;
  const std::vector<int> held = target_nodes(problem), boundary = boundary_nodes(problem.elements);
  if (!std::includes(held.begin(), held.end(), boundary.begin(), boundary.end())) {
    recorder.end(Status::not_applicable, "it needs a target at every node of the boundary");
    return {};
  }
  recorder.begin(Phase::solving);
  Vector x = with_all_targets(problem, skinned(problem));
  newton::Objective objective(problem.dim(), problem.node_count());
  // Weighted by volume: the boundary fixes the sum of signed contents then, which is what the method rests
  // on.
  objective.add<newton::EnergyTerm>(problem.elements, LiftedContent{});
  for (const int node : held) objective.pin(node);
  newton::Options newton;
  newton.scaled_gradient_tolerance = 0;
  newton.decrement_tolerance = 1e-12;
  newton.max_iterations = 10'000;
  // Without an inverted element the job is done, and the recorder's end stops Newton's method.
  recorder.stop_without_inversions();
  const newton::Summary summary = minimize(objective, x, newton, options, recorder);
  recorder.end(Status::stalled, "elements are inverted at a minimum: " + summary.message);
  return x;
}

}  // namespace

std::vector<Entry> lifted_content() {
  return {{{"lifted_content", "total lifted content", "Du et al. 2020", Kind::alternative, {}, false}, run}};
}

}  // namespace isostretch::baselines
