#include <isostretch/scene/pin_text.hpp>

#include <isostretch/core/error.hpp>
#include <isostretch/core/numbers.hpp>

#include <set>

namespace isostretch::scene {
namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& why) {
  throw Error(option + " " + text + ": " + why);
}

int vertex_of(const std::string& option, const std::string& text, const std::string& part) {
  const auto vertex = whole_number(part);
  if (!vertex || *vertex < 0) refuse(option, text, "'" + part + "' is not a vertex number (from 0)");
  return *vertex;
}

Value point_of(const std::string& option, const std::string& text, const std::string& part) {
  const auto numbers = split(part, ',');
  if (numbers.size() != 2) refuse(option, text, "'" + part + "' is not of the form U,V");
  const auto u = finite_number(numbers[0]), v = finite_number(numbers[1]);
  if (!u || !v) refuse(option, text, "'" + numbers[u ? 1 : 0] + "' is not a finite number");
  return std::vector<double>{*u, *v};
}

Value pin_of(const std::string& text, std::set<int>& seen) {
  const auto parts = split(text, ':');
  if (parts.size() > 2) refuse("--pin", text, "not of the form VERTEX or VERTEX:U,V");
  const int vertex = vertex_of("--pin", text, parts[0]);
  Value pin = Value::object("vertex", vertex);
  if (parts.size() == 2) pin["target"] = point_of("--pin", text, parts[1]);
  if (!seen.insert(vertex).second) refuse("--pin", text, "the vertex is pinned twice");
  return pin;
}

Value soft_pin_of(const std::string& text) {
  const auto parts = split(text, ':');
  if (parts.size() < 2 || parts.size() > 3)
    refuse("--soft-pin", text, "not of the form VERTEX:U,V or VERTEX:U,V:WEIGHT");
  Value pin = Value::object("vertex", vertex_of("--soft-pin", text, parts[0]));
  pin["target"] = point_of("--soft-pin", text, parts[1]);
  pin["soft"] = 1;
  if (parts.size() == 3) {
    const auto weight = finite_number(parts[2]);
    if (!weight || !(*weight > 0)) refuse("--soft-pin", text, "'" + parts[2] + "' is not a weight > 0");
    pin["soft"] = *weight;
  }
  return pin;
}

Value vertices_of(const std::string& option, const std::string& text) {
  Value vertices = Value::list();
  for (const std::string& word : split(text, ',')) {
    const auto vertex = whole_number(word);
    if (!vertex || *vertex < 0) throw Error(option + ": '" + word + "' is not a vertex number");
    vertices.push_back(*vertex);
  }
  return vertices;
}

Value line_of(const std::string& line, const std::string& text) {
  const std::string option = "--" + line;
  Value vertices = vertices_of(option, text);
  if (vertices.size() < 2) throw Error(option + ": '" + text + "' names less than two vertices");
  return Value::object({{"vertices", std::move(vertices)}, {"line", line}});
}

}  // namespace

void add_pins(const PinTexts& texts, Value& scene) {
  const auto group = [&]() -> Value& { return scene["parameterization"]; };
  std::set<int> seen;
  for (const std::string& text : texts.hard) group()["pins"].push_back(pin_of(text, seen));
  for (const std::string& text : texts.soft) group()["pins"].push_back(soft_pin_of(text));
  for (const std::string& text : texts.horizontal) group()["aligned"].push_back(line_of("horizontal", text));
  for (const std::string& text : texts.vertical) group()["aligned"].push_back(line_of("vertical", text));
  if (!texts.corners.empty()) group()["corners"] = vertices_of("--corners", texts.corners);
}

}  // namespace isostretch::scene
