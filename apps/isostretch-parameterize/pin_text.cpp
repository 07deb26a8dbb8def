#include "pin_text.hpp"

#include "common/numbers.hpp"

#include <isostretch/core/error.hpp>

#include <set>

namespace isostretch::app::parameterize {
namespace {

[[noreturn]] void refuse(const char* option, const std::string& text, const std::string& why) {
  throw Error(std::string(option) + " " + text + ": " + why);
}

int vertex_of(const char* option, const std::string& text, const std::string& part) {
  const auto vertex = whole_number(part);
  if (!vertex || *vertex < 0) refuse(option, text, "'" + part + "' is not a vertex number (from 0)");
  return *vertex;
}

Point2 point_of(const char* option, const std::string& text, const std::string& part) {
  const auto numbers = split(part, ',');
  if (numbers.size() != 2) refuse(option, text, "'" + part + "' is not of the form U,V");
  const auto u = finite_number(numbers[0]), v = finite_number(numbers[1]);
  if (!u || !v) refuse(option, text, "'" + numbers[u ? 1 : 0] + "' is not a finite number");
  return {*u, *v};
}

}  // namespace

std::vector<Pin> parse_pins(const std::vector<std::string>& texts) {
  std::vector<Pin> pins;
  std::set<int> seen;
  for (const std::string& text : texts) {
    const auto parts = split(text, ':');
    if (parts.size() > 2) refuse("--pin", text, "not of the form VERTEX or VERTEX:U,V");
    Pin pin;
    pin.vertex = vertex_of("--pin", text, parts[0]);
    if (parts.size() == 2) pin.target = point_of("--pin", text, parts[1]);
    if (!seen.insert(pin.vertex).second) refuse("--pin", text, "the vertex is pinned twice");
    pins.push_back(pin);
  }
  return pins;
}

std::vector<SoftPin> parse_soft_pins(const std::vector<std::string>& texts) {
  std::vector<SoftPin> pins;
  for (const std::string& text : texts) {
    const auto parts = split(text, ':');
    if (parts.size() < 2 || parts.size() > 3)
      refuse("--soft-pin", text, "not of the form VERTEX:U,V or VERTEX:U,V:WEIGHT");
    SoftPin pin;
    pin.vertex = vertex_of("--soft-pin", text, parts[0]);
    pin.target = point_of("--soft-pin", text, parts[1]);
    if (parts.size() == 3) {
      const auto weight = finite_number(parts[2]);
      if (!weight || !(*weight > 0)) refuse("--soft-pin", text, "'" + parts[2] + "' is not a weight > 0");
      pin.weight = *weight;
    }
    pins.push_back(pin);
  }
  return pins;
}

}  // namespace isostretch::app::parameterize
