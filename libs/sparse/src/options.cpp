#include <isostretch/core/error.hpp>
#include <isostretch/sparse/options.hpp>

#include <algorithm>
#include <array>
#include <string>

namespace isostretch::sparse {
namespace {

constexpr std::array<std::string_view, 4> ordering_names = {"automatic", "amd", "metis", "natural"};
constexpr std::array<std::string_view, 5> preconditioner_names = {
    "jacobi", "block_jacobi", "incomplete_cholesky", "stale_cholesky", "amg"};

template <class Enum, class Names>
Enum from_name(std::string_view name, const Names& names, const char* what) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<Enum>(found - names.begin());
  std::string list;
  for (const std::string_view candidate : names) list += (list.empty() ? "" : ", ") + std::string(candidate);
  throw Error(std::string("unknown ") + what + " '" + std::string(name) + "'; there are " + list);
}

}  // namespace

std::string_view ordering_name(Ordering ordering) noexcept {
  return ordering_names[static_cast<std::size_t>(ordering)];
}
std::string_view preconditioner_name(Preconditioner preconditioner) noexcept {
  return preconditioner_names[static_cast<std::size_t>(preconditioner)];
}

Ordering ordering_from_name(std::string_view name) {
  return from_name<Ordering>(name, ordering_names, "ordering");
}
Preconditioner preconditioner_from_name(std::string_view name) {
  return from_name<Preconditioner>(name, preconditioner_names, "preconditioner");
}

const std::vector<Preconditioner>& all_preconditioners() {
  static const std::vector<Preconditioner> preconditioners = [] {
    std::vector<Preconditioner> all;
    for (std::size_t i = 0; i < preconditioner_names.size(); ++i)
      all.push_back(static_cast<Preconditioner>(i));
    return all;
  }();
  return preconditioners;
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
