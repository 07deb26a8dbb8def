// Who of two methods is first.
#include "expect.hpp"

#include <isostretch/comparison/method_verdicts.hpp>

using namespace isostretch;

int main() {
  comparison::ComparedProblem problem;
  problem.optimum = 1;
  for (int m = 0; m < 2; ++m) {
    comparison::MethodCandidate candidate;
    candidate.info = baselines::methods()[m];
    comparison::MethodRun run;
    run.trace = {{0, 0, 2, 1}, {1, 2.0 - m, 1, 0}};
    candidate.runs.push_back(run);
    problem.candidates.push_back(candidate);
  }
  EXPECT(comparison::benchmark_goal({1e-6}, problem, {}).first == baselines::methods()[1].name);
}
