#include "methods.hpp"
#include "path.hpp"
#include "spectral.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

namespace isostretch::sdp_penalty {
namespace {

// Looser levels cost more Newton steps in all than they save.
constexpr double level_tolerance = 1e-8;

double first_factor(const PenaltyOptions& options) {
  if (options.first > 0) return options.first;
  return options.as_published ? 1 : 1e3;
}

double growth(const PenaltyOptions& options) {
  if (options.factor > 0) return options.factor;
  return options.as_published ? 10 : 30;
}

double last_factor(const PenaltyOptions& options) {
  if (options.last > 0) return options.last;
  if (options.as_published) return 1e15;
  return options.penalty == Penalty::cubic ? 1e21 : 1e12;
}

}  // namespace

void penalty_path(Workspace& work, const Options& options, Progress& progress, Vector& x) {
  const PenaltyOptions& path_options = options.penalty;
  Path path(work, options, progress, x);
  SpectralTerm term;
  SpectralPenalty& penalty = term.penalty;
  penalty.kind = path_options.penalty;
  double epsilon = path_options.epsilon;
  penalty.offset = work.system.problem().margin + epsilon;
  const double last = last_factor(path_options);
  int unfinished = 0;
  for (penalty.tau = std::min(first_factor(path_options), last);;
       penalty.tau = std::min(penalty.tau * growth(path_options), last)) {
    const Path::End end =
        path_options.as_published ? path.minimise_as_published(term) : path.minimise(term, level_tolerance);
    if (end == Path::End::progress) return;
    if (end == Path::End::limit) ++unfinished;
    if (penalty.tau >= last) break;
    if (path_options.lower_epsilon && !path_options.as_published && progress.feasible()) {
      epsilon *= 0.25 * options.gap_tolerance / progress.gap();
      penalty.offset = work.system.problem().margin + epsilon;
    }
  }
  if (progress.certified())
    return progress.end(Status::optimal, "feasible, and the certified gap is within gap_tolerance");
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "the path ends at the penalty factor %g", last);
  std::string reason = text.data();
  if (unfinished > 0) reason += ", " + std::to_string(unfinished) + " levels not converged";
  progress.give_up(Status::path_end, reason, x, {path.multiplier(), {}});
}

}  // namespace isostretch::sdp_penalty
