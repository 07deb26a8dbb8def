#include <isostretch/core/error.hpp>
#include <isostretch/newton/options.hpp>

#include <cmath>

namespace isostretch::newton {
namespace {

constexpr Projection all_projections[] = {Projection::adaptive,     Projection::clamp,
                                          Projection::abs,          Projection::none,
                                          Projection::trust_region, Projection::progressive};

void require(bool condition, const char* text) {
  if (!condition) throw Error(std::string("newton options: ") + text);
}

}  // namespace

std::string_view projection_name(Projection projection) noexcept {
  switch (projection) {
    case Projection::adaptive:
      return "adaptive";
    case Projection::clamp:
      return "clamp";
    case Projection::abs:
      return "abs";
    case Projection::none:
      return "none";
    case Projection::trust_region:
      return "trust_region";
    case Projection::progressive:
      return "progressive";
  }
  return "?";
}

std::vector<std::string> projection_names() {
  std::vector<std::string> names;
  for (const Projection projection : all_projections) names.emplace_back(projection_name(projection));
  return names;
}

Projection projection_from_name(std::string_view name) {
  for (const Projection projection : all_projections)
    if (projection_name(projection) == name) return projection;
  throw Error("unknown projection '" + std::string(name) +
              "'; there are adaptive, clamp, abs, none, trust_region, progressive");
}

void Options::validate() const {
  require(filter_threshold >= 0, "filter_threshold must not be negative");
  require(gradient_tolerance >= 0 && scaled_gradient_tolerance >= 0 && decrement_tolerance >= 0 &&
              relative_energy_tolerance >= 0,
          "tolerances must not be negative");
  require(max_iterations >= 0, "max_iterations must not be negative");
  require(time_limit >= 0, "time_limit must not be negative");
  require(armijo > 0 && armijo < 0.5, "armijo must be between 0 and 0.5");
  require(backtracking_factor > 0 && backtracking_factor < 1, "backtracking_factor must be between 0 and 1");
  require(max_backtracks >= 1, "max_backtracks must be at least 1");
  require(domain_fraction > 0 && domain_fraction < 1, "domain_fraction must be between 0 and 1");
  require(relative_shift >= 0 && std::isfinite(relative_shift), "relative_shift must not be negative");
  require(largest_forcing >= 0 && largest_forcing < 1, "largest_forcing must be between 0 and 1");
  require(max_shifts >= 0, "max_shifts must not be negative");
}

}  // namespace isostretch::newton
