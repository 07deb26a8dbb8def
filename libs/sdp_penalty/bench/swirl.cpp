// Time to a certified solution of the swirl: a square of 2 n^2 triangles, its middle turned.
//
//   isostretch_sdp_swirl n degrees gap
#include "../tests/swirl.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/sdp_penalty/interior_point.hpp>

#include <cstdio>
#include <exception>
#include <string>

int main(int argc, char** argv) {
  using namespace isostretch;
  try {
    if (argc != 4) throw Error("arguments: cells across, degrees, certified gap");
    const sdp_penalty::Problem problem = tests::swirl(std::stoi(argv[1]), std::stod(argv[2]));
    sdp_penalty::InteriorPointOptions options;
    options.gap_tolerance = std::stod(argv[3]);
    Vector x;
    const auto summary = sdp_penalty::solve_interior_point(problem, x, options);
    double preview = -1;  // first iterate after which none has an inverted element
    for (const auto& row : summary.trace) {
      if (row.inverted > 0) preview = -1;
      if (row.inverted == 0 && preview < 0) preview = row.seconds;
    }
    std::printf(
        "%d triangles, %s degrees: %s, %d factorizations, %.4f s, without inversions from %.4f s, "
        "inverted at first %d, gap %.1e\n",
        problem.element_count(), argv[2], std::string(sdp_penalty::status_name(summary.status)).c_str(),
        summary.linear_solves, summary.seconds, preview, summary.trace.front().inverted, summary.gap);
    return summary.status == sdp_penalty::Status::optimal ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
