#include <isostretch/core/error.hpp>
#include <isostretch/projection/filter.hpp>

namespace isostretch::projection {

std::string_view filter_name(Filter filter) noexcept {
  switch (filter) {
    case Filter::none:
      return "none";
    case Filter::clamp:
      return "clamp";
    case Filter::abs:
      return "abs";
  }
  return "?";
}

std::vector<std::string> filter_names() {
  return {"none", "clamp", "abs"};
}

Filter filter_from_name(std::string_view name) {
  for (const Filter filter : {Filter::none, Filter::clamp, Filter::abs})
    if (filter_name(filter) == name) return filter;
  throw Error("unknown filter '" + std::string(name) + "'; there are none, clamp, abs");
}

}  // namespace isostretch::projection
