#include <isostretch/newton/options.hpp>

namespace isostretch::newton {

std::string_view projection_name(Projection projection) noexcept {
  return name_of(choice_names(projection), projection);
}

std::vector<std::string> projection_names() {
  return all_names(choice_names(Projection{}));
}

Projection projection_from_name(std::string_view name) {
  return choice_from_name(choice_names(Projection{}), name, "projection");
}

void Options::validate() const {
  check_ranges(*this);
}

}  // namespace isostretch::newton
