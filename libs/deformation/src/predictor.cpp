#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/deformation/predictor.hpp>

#include <utility>

namespace isostretch::deformation {
namespace {

// In space factors grow much faster than the body: beyond so many nodes only the harmonic system, which
// multigrid solves, is quick enough for a guess.
constexpr Eigen::Index most_to_factorize = 60000;

sparse::Options multigrid() {
  sparse::Options options;
  options.backend = sparse::Backend::pcg;
  options.pcg_preconditioner = sparse::Preconditioner::amg;
  options.pcg_max_iterations = 500;
  return options;
}

}  // namespace

Predictor::Predictor(InitialGuess kind, const SolidModel& body, const HandleSet& handle_set, Warn warn)
    : body_(body),
      handle_set_(handle_set),
      kind_(kind),
      rest_(body.rest_positions()),
      warn_(std::move(warn)) {
  choose_ways();
  for (std::size_t way = 0; way < ways_.size(); ++way)
    if (prepare(way)) break;
}

void Predictor::choose_ways() {
  if (kind_ != InitialGuess::harmonic && kind_ != InitialGuess::biharmonic) return;
  const bool large = body_.dim == 3 && body_.nodes.rows() > most_to_factorize;
  if (large && kind_ == InitialGuess::biharmonic)
    log(LogLevel::info, formatted("guess: harmonic, for biharmonic is too slow in space above %ld vertices",
                                  static_cast<long>(most_to_factorize)));
  if (large) ways_.push_back({"harmonic (multigrid)", handles::SpreadKind::harmonic, multigrid()});
  if (!large && kind_ == InitialGuess::biharmonic)
    ways_.push_back({"biharmonic", handles::SpreadKind::biharmonic, handles::factorizing()});
  ways_.push_back({"harmonic", handles::SpreadKind::harmonic, handles::factorizing()});
}

bool Predictor::prepare(std::size_t way) {
  Way& w = ways_[way];
  if (w.spreader || w.hopeless) return !w.hopeless;
  try {
    w.spreader.emplace(body_.full_rank_elements(), handle_set_.nodes(), w.kind, w.solver);
  } catch (const Error& error) {
    w.hopeless = true;
    warn_of(way, error.what());
  }
  return !w.hopeless;
}

// Every time from the best on, so that a run that was interrupted makes the same guesses.
Vector Predictor::spread(const Vector& displacement) {
  for (std::size_t way = 0; way < ways_.size(); ++way) {
    if (!prepare(way)) continue;
    try {
      Vector spread = ways_[way].spreader->spread(displacement);
      if (!spread.allFinite()) throw Error("spread: displacements that are not finite");
      return spread;
    } catch (const Error& error) {
      warn_of(way, error.what());
    }
  }
  return Vector::Zero(displacement.size());
}

void Predictor::warn_of(std::size_t way, const std::string& what) {
  if (std::exchange(ways_[way].warned, true)) return;
  const std::string next = way + 1 < ways_.size() ? ways_[way + 1].name : "previous";
  warn_("the guess " + ways_[way].name + " failed (" + what + "), " + next + " takes its place");
}

Vector Predictor::guess(const Vector& positions, double from, double to, bool again) {
  Vector x = kind_ == InitialGuess::rest && !again ? rest_ : positions;
  if (!ways_.empty()) {
    Vector before = rest_, after = rest_;
    handle_set_.place_all(from, before);
    handle_set_.place_all(to, after);
    x += spread(after - before);
  }
  handle_set_.place_hard(to, x);
  return x;
}

}  // namespace isostretch::deformation
