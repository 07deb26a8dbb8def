#include <isostretch/scene/handle_text.hpp>

#include <isostretch/core/error.hpp>
#include <isostretch/core/numbers.hpp>

#include <vector>

namespace isostretch::scene {
namespace {

[[noreturn]] void fail(const std::string& part, const std::string& what) {
  throw Error("--handle: '" + part + "' " + what);
}

// Splits "name<mark>rest".
bool cut(const std::string& text, char mark, std::string& name, std::string& rest) {
  const std::size_t at = text.find(mark);
  name = text.substr(0, at);
  rest = at == std::string::npos ? std::string() : text.substr(at + 1);
  return at != std::string::npos;
}

std::vector<double> numbers(const std::string& part, const std::string& text) {
  std::vector<double> values;
  for (const std::string& word : split(text, ',')) {
    const auto value = finite_number(word);
    if (!value) fail(part, "has '" + word + "' for a number");
    values.push_back(*value);
  }
  return values;
}

double number(const std::string& part, const std::string& text) {
  const std::vector<double> values = numbers(part, text);
  if (values.size() != 1) fail(part, "needs one number");
  return values[0];
}

Value point(const std::vector<double>& values, std::size_t from, std::size_t dim) {
  return Value(std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(from),
                                   values.begin() + static_cast<std::ptrdiff_t>(from + dim)));
}

// Coordinates of so many points, in 2D or 3D, and so many numbers more: the dimension.
std::size_t dimension(const std::string& part, std::size_t count, std::size_t points, std::size_t more) {
  for (const std::size_t dim : {2U, 3U})
    if (count == points * dim + more) return dim;
  fail(part, "has " + std::to_string(count) + " numbers; see --help");
}

Value slab(const std::string& part, const std::string& rest) {
  const std::vector<std::string> words = split(rest, ',');
  if (words.size() != 3) fail(part, "is not slab:AXIS,min|max,FRACTION");
  return Value::object({{"axis", words[0]}, {"end", words[1]}, {"fraction", number(part, words[2])}});
}

Value list(const std::string& part, const std::string& rest) {
  Value vertices = Value::list();
  for (const std::string& word : split(rest, ',')) {
    const auto vertex = whole_number(word);
    if (!vertex || *vertex < 0) fail(part, "has '" + word + "' for a vertex number");
    vertices.push_back(*vertex);
  }
  return vertices;
}

Value selection(const std::string& part) {
  std::string kind, rest;
  cut(part, ':', kind, rest);
  if (part == "all") return "all";
  if (kind == "slab") return Value::object("slab", slab(part, rest));
  if (kind == "group") return Value::object("group", rest);
  if (kind == "vertices") return Value::object("vertices", list(part, rest));
  if (kind != "box" && kind != "sphere" && kind != "segment" && kind != "nearest" && kind != "patch")
    fail(part, "is no selection: all, box, sphere, segment, vertices, slab, nearest, patch, group");
  const std::vector<double> n = numbers(part, rest);
  if (kind == "box") {
    const std::size_t dim = dimension(part, n.size(), 2, 0);
    return Value::object(kind, Value::object({{"min", point(n, 0, dim)}, {"max", point(n, dim, dim)}}));
  }
  if (kind == "segment") {
    const std::size_t dim = dimension(part, n.size(), 2, 1);
    return Value::object(
        kind,
        Value::object({{"from", point(n, 0, dim)}, {"to", point(n, dim, dim)}, {"distance", n.back()}}));
  }
  if (kind == "nearest") {
    const std::size_t dim = dimension(part, n.size(), 1, 0);
    return Value::object(kind, Value::object("point", point(n, 0, dim)));
  }
  const std::size_t dim = dimension(part, n.size(), 1, 1);
  if (kind == "sphere")
    return Value::object(kind, Value::object({{"center", point(n, 0, dim)}, {"radius", n.back()}}));
  return Value::object(kind, Value::object({{"point", point(n, 0, dim)}, {"distance", n.back()}}));
}

Value rotation(const std::string& part, const std::string& value) {
  std::string axis, degrees;
  if (!cut(value, ':', axis, degrees)) return Value::object("degrees", number(part, value));  // in the plane
  return Value::object({{"axis", numbers(part, axis)}, {"degrees", number(part, degrees)}});
}

void add_property(const std::string& part, Value& handle) {
  std::string key, value;
  if (part == "hard") {
    handle[part] = true;
    return;
  }
  if (!cut(part, '=', key, value)) fail(part, "is not of the form key=value");
  if (handle.has(key)) fail(part, "is given twice");
  if (key == "rotate")
    handle[key] = rotation(part, value);
  else if (key == "translate" || key == "center")
    handle[key] = numbers(part, value);
  else if (key == "scale" || key == "soft")
    handle[key] = number(part, value);
  else if (key == "name")
    handle[key] = value;
  else
    fail(part, "has an unknown key; there are translate, rotate, scale, center, soft, hard, name");
}

}  // namespace

Value handle_from_text(const std::string& text) {
  const std::vector<std::string> parts = split(text, ';');
  Value handle = Value::object("select", selection(parts[0]));
  for (std::size_t i = 1; i < parts.size(); ++i) add_property(parts[i], handle);
  return handle;
}

std::string handle_help(Holding holding) {
  const char* const how = holding == Holding::hard ? "  soft=WEIGHT                   holds it softly\n"
                                                   : "  hard                          is held exactly\n";
  return std::string(
             "A part of the body and how it moves. Without a motion\n"
             "it is held where it is. May be repeated. In quotes:\n"
             "SELECTION[;KEY=VALUE...], where SELECTION is\n"
             "  all                           every vertex\n"
             "  slab:AXIS,min|max,FRACTION    one end of the box\n"
             "  box:X,Y,Z,X,Y,Z               between two corners\n"
             "  sphere:X,Y,Z,RADIUS           in a ball\n"
             "  segment:X,Y,Z,X,Y,Z,DISTANCE  near a line, a bone\n"
             "  patch:X,Y,Z,DISTANCE          along the surface\n"
             "  nearest:X,Y,Z                 nearest to a point\n"
             "  vertices:N[,N...]             by number, from 0\n"
             "  group:NAME                    a group in the file\n"
             "and KEY=VALUE is\n"
             "  translate=X,Y,Z               moves by that much\n"
             "  rotate=X,Y,Z:DEGREES          turns about an axis\n"
             "  scale=S                       grows to S times\n"
             "  center=X,Y,Z                  of turning, growing\n") +
         how +
         "  name=TEXT                     is called in reports\n"
         "In the plane points have two numbers: rotate=DEGREES.";
}

}  // namespace isostretch::scene
