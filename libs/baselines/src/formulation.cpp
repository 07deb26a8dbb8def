#include "formulation.hpp"

#include "nearest_matrix_term.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace isostretch::baselines {

newton::Objective elastic_objective(const sdp_penalty::Problem& problem) {
  newton::Objective objective(problem.dim(), problem.node_count());
  objective.add<NearestMatrixTerm>(problem);
  std::vector<newton::SoftPin> pins;
  for (const sdp_penalty::Target& target : problem.targets) {
    if (target.hard)
      objective.pin(target.node);
    else if (problem.alpha > 0)
      pins.push_back({target.node, target.position, problem.alpha});
  }
  objective.add<newton::SoftPinTerm>(problem.dim(), problem.node_count(), std::move(pins));
  return objective;
}

namespace {

template <class Which>
Vector with_targets(const sdp_penalty::Problem& problem, Vector x, const Which& which) {
  for (const sdp_penalty::Target& target : problem.targets)
    for (int r = 0; which(target) && r < problem.dim(); ++r)
      x[target.node * problem.dim() + r] = target.position[static_cast<std::size_t>(r)];
  return x;
}

}  // namespace

Vector with_all_targets(const sdp_penalty::Problem& problem, Vector x) {
  return with_targets(problem, std::move(x), [](const sdp_penalty::Target&) { return true; });
}

Vector with_hard_targets(const sdp_penalty::Problem& problem, Vector x) {
  return with_targets(problem, std::move(x), [](const sdp_penalty::Target& target) { return target.hard; });
}

std::vector<int> target_nodes(const sdp_penalty::Problem& problem) {
  std::set<int> nodes;
  for (const sdp_penalty::Target& target : problem.targets) nodes.insert(target.node);
  return {nodes.begin(), nodes.end()};
}

assembly::Elements weighted_elements(const sdp_penalty::Problem& problem) {
  assembly::Elements elements = problem.elements;
  elements.weights = problem.weights;
  return elements;
}

int iterations_left(const Options& options, Recorder& recorder, int otherwise) {
  const int limit = options.limits.iterations > 0 ? options.limits.iterations : otherwise;
  return std::max(0, limit - recorder.result().iterations);
}

newton::Summary minimize(newton::Objective& objective, Vector& x, newton::Options options,
                         const Options& limits, Recorder& recorder) {
  options.max_iterations = std::min(options.max_iterations, iterations_left(limits, recorder, 1'000'000));
  newton::Summary summary =
      newton::minimize(objective, x, options, [&](const newton::Iteration& row, const Vector& iterate) {
        const bool is_start = row.iteration == 0 && recorder.points() > 0;
        return is_start || recorder.record(iterate) ? newton::CallbackAction::proceed
                                                    : newton::CallbackAction::stop;
      });
  Result& result = recorder.result();
  result.iterations += summary.iterations;
  result.linear_solves = std::max(0, result.linear_solves) + summary.factorizations;
  if (options.max_iterations == 0 ||
      (limits.limits.iterations > 0 && iterations_left(limits, recorder, 0) == 0))
    recorder.end(Status::iteration_limit, "the iteration limit is reached");
  return summary;
}

}  // namespace isostretch::baselines
