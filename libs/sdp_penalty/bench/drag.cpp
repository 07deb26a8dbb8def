// A handle dragged: the middle of a square (2 n^2 triangles) or of a cube (6 n^3 tets) is turned to an angle,
// then further by 2 degrees at a time with the same Solver.
//
//   isostretch_sdp_drag square|cube n degrees gap steps [method] [preconditioner]
//
// With a preconditioner the systems are solved by conjugate gradients instead of a factorization.
#include "../tests/swirl.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/sdp_penalty/solver.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace {

using namespace isostretch;

struct Times {
  double preview = -1, certified = -1;
};

// Preview: the first iterate after which none has an inverted element.
Times report(const char* what, double degrees, const sdp_penalty::Summary& summary) {
  Times times;
  for (const auto& row : summary.trace) {
    if (row.inverted > 0) times.preview = -1;
    if (row.inverted == 0 && times.preview < 0) times.preview = row.seconds;
  }
  if (summary.status == sdp_penalty::Status::optimal) times.certified = summary.seconds;
  std::printf(
      "%s %.0f degrees: %s, %d iterations, %d linear solves, inverted at first %d, without from %.4f s, end "
      "%.4f s, gap %.1e, least eigenvalue %.1e\n",
      what, degrees, std::string(sdp_penalty::status_name(summary.status)).c_str(), summary.iterations,
      summary.linear_solves, summary.trace.front().inverted, times.preview, summary.seconds, summary.gap,
      summary.min_eigenvalue);
  if (summary.status != sdp_penalty::Status::optimal) std::printf("  %s\n", summary.message.c_str());
  std::fflush(stdout);
  return times;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 6) throw Error("arguments: square|cube n degrees gap steps [method] [preconditioner]");
    const bool cube = argv[1] == std::string("cube");
    const int n = std::stoi(argv[2]), steps = std::stoi(argv[5]);
    const double degrees = std::stod(argv[3]);
    sdp_penalty::Options options;
    options.gap_tolerance = std::stod(argv[4]);
    if (argc > 6) options.method = sdp_penalty::method_from_name(argv[6]);
    if (argc > 7) {
      options.solver.backend = sparse::Backend::pcg;
      options.solver.pcg_preconditioner = sparse::preconditioner_from_name(argv[7]);
    }
    const auto problem = [&](double angle) {
      return cube ? tests::swirl_in_space(n, angle) : tests::swirl(n, angle);
    };
    sdp_penalty::Solver solver(options);
    Vector x;
    const auto first = problem(degrees);
    std::printf("%d elements, %d nodes, %zu targets\n", first.element_count(), first.node_count(),
                first.targets.size());
    report("first", degrees, solver.solve(first, x));
    std::vector<double> previews, ends;
    for (int i = 1; i <= steps; ++i) {
      const Times times = report("drag", degrees + 2 * i, solver.solve(problem(degrees + 2 * i), x));
      previews.push_back(times.preview);
      ends.push_back(times.certified);
    }
    if (steps > 0)
      std::printf("drags, medians: preview %.4f s, certified %.4f s\n", median(previews), median(ends));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
