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
    case Filter::bounded_abs:
      return "bounded_abs";
  }
  return "?";
}

std::vector<std::string> filter_names() {
  return {"none", "clamp", "abs", "bounded_abs"};
}

Filter filter_from_name(std::string_view name) {
  for (const Filter filter : {Filter::none, Filter::clamp, Filter::abs, Filter::bounded_abs})
    if (filter_name(filter) == name) return filter;
  throw Error("unknown filter '" + std::string(name) + "'; there are none, clamp, abs, bounded_abs");
}

}  // namespace isostretch::projection
