#include <isostretch/core/error.hpp>
#include <isostretch/sparse/options.hpp>

#include <algorithm>

namespace isostretch::sparse {
std::string_view backend_name(Backend backend) noexcept {
  return name_of(choice_names(backend), backend);
}
std::string_view ordering_name(Ordering ordering) noexcept {
  return name_of(choice_names(ordering), ordering);
}
std::string_view preconditioner_name(Preconditioner preconditioner) noexcept {
  return name_of(choice_names(preconditioner), preconditioner);
}

Backend backend_from_name(std::string_view name) {
  return choice_from_name(choice_names(Backend{}), name, "solver back end");
}
Ordering ordering_from_name(std::string_view name) {
  return choice_from_name(choice_names(Ordering{}), name, "ordering");
}
Preconditioner preconditioner_from_name(std::string_view name) {
  return choice_from_name(choice_names(Preconditioner{}), name, "preconditioner");
}

const std::vector<Backend>& available_backends() {
  static const std::vector<Backend> backends = {
#if defined(ISOSTRETCH_WITH_CHOLMOD)
    Backend::cholmod_supernodal,
    Backend::cholmod_simplicial,
#endif
    Backend::eigen_ldlt,
    Backend::pcg
  };
  return backends;
}

const std::vector<Preconditioner>& all_preconditioners() {
  static const std::vector<Preconditioner> preconditioners = [] {
    std::vector<Preconditioner> all;
    for (const auto& [name, preconditioner] : choice_names(Preconditioner{})) all.push_back(preconditioner);
    return all;
  }();
  return preconditioners;
}

bool is_available(Backend backend) {
  const auto& backends = available_backends();
  return backend == Backend::automatic ||
         std::find(backends.begin(), backends.end(), backend) != backends.end();
}

const std::vector<Ordering>& available_orderings() {
  static const std::vector<Ordering> orderings = {
    Ordering::amd,
#if defined(ISOSTRETCH_WITH_CHOLMOD)
    Ordering::metis,
#endif
    Ordering::natural
  };
  return orderings;
}

}  // namespace isostretch::sparse
