#include "common/guess.hpp"

#include "common/terminal.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>

#include <utility>

namespace isostretch::app {
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

Guesser::Guesser(Guess kind, const Body& body, const Rig& rig, Warn warn)
    : body_(body), rig_(rig), kind_(kind), rest_(body.rest_positions()), warn_(std::move(warn)) {
  choose_ways();
  for (std::size_t way = 0; way < ways_.size(); ++way)
    if (prepare(way)) break;
}

void Guesser::choose_ways() {
  if (kind_ != Guess::harmonic && kind_ != Guess::biharmonic) return;
  const bool large = body_.dim == 3 && body_.nodes.rows() > most_to_factorize;
  if (large && kind_ == Guess::biharmonic)
    notice(formatted("guess: harmonic, for biharmonic is too slow in space above %ld vertices",
                     static_cast<long>(most_to_factorize)));
  if (large) ways_.push_back({"harmonic (multigrid)", handles::SpreadKind::harmonic, multigrid()});
  if (!large && kind_ == Guess::biharmonic)
    ways_.push_back({"biharmonic", handles::SpreadKind::biharmonic, handles::factorizing()});
  ways_.push_back({"harmonic", handles::SpreadKind::harmonic, handles::factorizing()});
}

bool Guesser::prepare(std::size_t way) {
  Way& w = ways_[way];
  if (w.spreader || w.hopeless) return !w.hopeless;
  try {
    w.spreader.emplace(body_.full_rank_elements(), rig_.nodes(), w.kind, w.solver);
  } catch (const Error& error) {
    w.hopeless = true;
    warn_of(way, error.what());
  }
  return !w.hopeless;
}

// Every time from the best on, so that a run that was interrupted makes the same guesses.
Vector Guesser::spread(const Vector& displacement) {
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

void Guesser::warn_of(std::size_t way, const std::string& what) {
  if (std::exchange(ways_[way].warned, true)) return;
  const std::string next = way + 1 < ways_.size() ? ways_[way + 1].name : "previous";
  warn_("the guess " + ways_[way].name + " failed (" + what + "), " + next + " takes its place");
}

Vector Guesser::guess(const Vector& positions, double from, double to, bool again) {
  Vector x = kind_ == Guess::rest && !again ? rest_ : positions;
  if (!ways_.empty()) {
    Vector before = rest_, after = rest_;
    rig_.place_all(from, before);
    rig_.place_all(to, after);
    x += spread(after - before);
  }
  rig_.place_hard(to, x);
  return x;
}

}  // namespace isostretch::app
