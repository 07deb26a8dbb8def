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
  choose_methods();
  for (std::size_t method = 0; method < methods_.size(); ++method)
    if (prepare(method)) break;
}

void Predictor::choose_methods() {
  if (kind_ != InitialGuess::harmonic && kind_ != InitialGuess::biharmonic) return;
  const bool large = body_.dim == 3 && body_.nodes.rows() > most_to_factorize;
  if (large && kind_ == InitialGuess::biharmonic)
    log(LogLevel::info, formatted("guess: harmonic, for biharmonic is too slow in space above %ld vertices",
                                  static_cast<long>(most_to_factorize)));
  if (large) methods_.push_back({"harmonic (multigrid)", handles::ExtensionKind::harmonic, multigrid()});
  if (!large && kind_ == InitialGuess::biharmonic)
    methods_.push_back({"biharmonic", handles::ExtensionKind::biharmonic, handles::factorizing()});
  methods_.push_back({"harmonic", handles::ExtensionKind::harmonic, handles::factorizing()});
}

bool Predictor::prepare(std::size_t method) {
  Method& m = methods_[method];
  if (m.extension || m.hopeless) return !m.hopeless;
  try {
    m.extension.emplace(body_.full_rank_elements(), handle_set_.nodes(), m.kind, m.solver);
  } catch (const Error& error) {
    m.hopeless = true;
    warn_of(method, error.what());
  }
  return !m.hopeless;
}

// Every time from the best on, so that a run that was interrupted makes the same guesses.
Vector Predictor::extend(const Vector& displacement) {
  for (std::size_t method = 0; method < methods_.size(); ++method) {
    if (!prepare(method)) continue;
    try {
      Vector extended = methods_[method].extension->extend(displacement);
      if (!extended.allFinite()) throw Error("spread: displacements that are not finite");
      return extended;
    } catch (const Error& error) {
      warn_of(method, error.what());
    }
  }
  return Vector::Zero(displacement.size());
}

void Predictor::warn_of(std::size_t method, const std::string& what) {
  if (std::exchange(methods_[method].warned, true)) return;
  const std::string next = method + 1 < methods_.size() ? methods_[method + 1].name : "previous";
  warn_("the guess " + methods_[method].name + " failed (" + what + "), " + next + " takes its place");
}

Vector Predictor::guess(const Vector& positions, double from, double to, bool again) {
  Vector x = kind_ == InitialGuess::rest && !again ? rest_ : positions;
  if (!methods_.empty()) {
    Vector before = rest_, after = rest_;
    handle_set_.place_all(from, before);
    handle_set_.place_all(to, after);
    x += extend(after - before);
  }
  handle_set_.place_hard(to, x);
  return x;
}

}  // namespace isostretch::deformation
