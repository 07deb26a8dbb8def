// Back ends by name: those compiled in, and solvers registered from outside.
#include "backends.hpp"

#include <isostretch/core/error.hpp>

#include <algorithm>
#include <array>
#include <deque>
#include <mutex>
#include <string>
#include <utility>

namespace isostretch::sparse {
namespace {

constexpr std::array<std::string_view, 6> built_in = {
    "automatic", "cholmod_supernodal", "cholmod_simplicial", "multifrontal", "eigen_ldlt", "pcg"};

struct Registered {
  std::string name;
  SolverFactory factory;
};

// Entries stay where they are, so that names can be handed out as views.
struct Registry {
  std::mutex mutex;
  std::deque<Registered> entries;
};

Registry& registry() {
  static Registry only;
  return only;
}

// The registered solver that stands behind a back end; null for the built-in ones.
const Registered* find_registered(Backend backend) {
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  const auto index = static_cast<std::size_t>(backend);
  if (index < built_in.size() || index - built_in.size() >= all.entries.size()) return nullptr;
  return &all.entries[index - built_in.size()];
}

// All that there are, compiled in or not, in the order of their numbers.
std::vector<std::string_view> all_names() {
  std::vector<std::string_view> names(built_in.begin(), built_in.end());
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  for (const Registered& entry : all.entries) names.push_back(entry.name);
  return names;
}

}  // namespace

Backend register_solver(std::string_view name, SolverFactory factory) {
  if (name.empty()) throw Error(ErrorKind::misuse, "register_solver: the name is empty");
  if (!factory)
    throw Error(ErrorKind::misuse, "register_solver: there is no factory for '" + std::string(name) + "'");
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  if (std::find(built_in.begin(), built_in.end(), name) != built_in.end() ||
      std::any_of(all.entries.begin(), all.entries.end(),
                  [&](const Registered& entry) { return entry.name == name; }))
    throw Error(ErrorKind::misuse, "register_solver: the name '" + std::string(name) + "' is taken");
  all.entries.push_back({std::string(name), std::move(factory)});
  return static_cast<Backend>(built_in.size() + all.entries.size() - 1);
}

std::unique_ptr<Solver> make_registered_solver(const Options& options) {
  const Registered* const found = find_registered(options.backend);
  if (found == nullptr) return nullptr;
  auto solver = found->factory(options);
  if (!solver) throw Error("the factory of the linear solver '" + found->name + "' made none");
  return solver;
}

ChoiceSlot choice_slot(Backend& backend) {
  return {[] {
            const auto names = all_names();
            return std::vector<std::string>(names.begin(), names.end());
          },
          [&backend] { return std::string(backend_name(backend)); },
          [&backend](const std::string& name) { backend = backend_from_name(name); }};
}

std::string_view backend_name(Backend backend) noexcept {
  if (const Registered* const found = find_registered(backend)) return found->name;
  const auto index = static_cast<std::size_t>(backend);
  return index < built_in.size() ? built_in[index] : "?";
}

Backend backend_from_name(std::string_view name) {
  const std::vector<std::string_view> names = all_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<Backend>(found - names.begin());
  std::string list;
  for (const std::string_view candidate : names) list += (list.empty() ? "" : ", ") + std::string(candidate);
  throw Error("unknown solver back end '" + std::string(name) + "'; there are " + list);
}

std::vector<Backend> available_backends() {
  std::vector<Backend> backends = {
    Backend::multifrontal,
#if defined(ISOSTRETCH_WITH_CHOLMOD)
    Backend::cholmod_supernodal,
    Backend::cholmod_simplicial,
#endif
    Backend::eigen_ldlt,
    Backend::pcg
  };
  const std::size_t all = all_names().size();
  for (std::size_t i = built_in.size(); i < all; ++i) backends.push_back(static_cast<Backend>(i));
  return backends;
}

bool is_available(Backend backend) {
  const auto backends = available_backends();
  return backend == Backend::automatic ||
         std::find(backends.begin(), backends.end(), backend) != backends.end();
}

}  // namespace isostretch::sparse
