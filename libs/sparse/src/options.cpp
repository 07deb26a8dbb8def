#include <isostretch/sparse/options.hpp>

namespace isostretch::sparse {

std::string_view ordering_name(Ordering ordering) noexcept {
  return name_of(choice_names(ordering), ordering);
}
std::string_view preconditioner_name(Preconditioner preconditioner) noexcept {
  return name_of(choice_names(preconditioner), preconditioner);
}

Ordering ordering_from_name(std::string_view name) {
  return choice_from_name(choice_names(Ordering{}), name, "ordering");
}
Preconditioner preconditioner_from_name(std::string_view name) {
  return choice_from_name(choice_names(Preconditioner{}), name, "preconditioner");
}

const std::vector<Preconditioner>& all_preconditioners() {
  static const std::vector<Preconditioner> preconditioners = [] {
    std::vector<Preconditioner> all;
    for (const auto& [name, preconditioner] : choice_names(Preconditioner{})) all.push_back(preconditioner);
    return all;
  }();
  return preconditioners;
}

const std::vector<Ordering>& available_orderings() {
  static const std::vector<Ordering> orderings = {
    Ordering::amd,
#if defined(ISOSTRETCH_WITH_METIS)
    Ordering::metis,
#endif
    Ordering::natural
  };
  return orderings;
}

}  // namespace isostretch::sparse
