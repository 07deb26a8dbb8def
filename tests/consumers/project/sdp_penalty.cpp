// A square of two triangles is asked to turn inside out, and does not.
#include "turned_square.hpp"

#include <isostretch/sdp_penalty/solver.hpp>

int main() {
  using namespace isostretch;
  const sdp_penalty::Problem problem = turned_square();
  Vector x;
  const auto summary = sdp_penalty::solve(problem, x);
  const bool inverted_before = summary.trace.front().inverted == 2;
  return summary.status == sdp_penalty::Status::optimal && inverted_before && summary.inverted == 0 ? 0 : 1;
}
