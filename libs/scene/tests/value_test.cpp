#include <isostretch/core/error.hpp>
#include <isostretch/scene/node.hpp>
#include <isostretch/scene/option_values.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace isostretch;
using scene::Node;
using scene::Value;

namespace {

enum class Color { red, green };
constexpr ChoiceNames<Color, 2> choice_names(Color) {
  return {{{"red", Color::red}, {"green", Color::green}}};
}

struct Inner {
  double share = 0.5;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit(Field{"share", "A share", inside(0, 1)}, self.share);
  }
};

struct Options {
  bool on = true;
  int count = 3;
  double bound = std::numeric_limits<double>::infinity();
  std::string name = "none";
  Color color = Color::green;
  Inner inner;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit(Field{"on", "Whether"}, self.on);
    visit(Field{"count", "How many", between(1, 5)}, self.count);
    visit(Field{"bound", "At most", above(1), "metres"}, self.bound);
    visit(Field{"name", "A name"}, self.name);
    visit(Field{"color", "Which"}, self.color);
    visit(Field{"inner", "More"}, self.inner);
  }
};

Options read(const std::string& json) {
  const Value value = scene::parse_json(json, "test");
  Options options;
  scene::read_options(Node(value, "options"), options);
  return options;
}

std::string error_of(const std::string& json) {
  try {
    read(json);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("what is parsed is written again") {
  for (const char* text : {"null", "true", "-1.5", "\"a\\nb\"", "[1,[2,{}],\"x\"]",
                           "{\"b\":1,\"a\":{\"c\":[]}}", "123456789012", "1e-300", "0.1"}) {
    CAPTURE(text);
    const Value value = scene::parse_json(text, "test");
    CHECK(scene::to_json(value) == text);
    CHECK(scene::parse_json(scene::to_json(value, 2), "test") == value);
  }
  CHECK(std::signbit(scene::parse_json(scene::to_json(Value(-0.0)), "test").number()));
  CHECK(scene::to_json(Value(std::nan(""))) == "null");
}

TEST_CASE("what is no document is refused with its place") {
  CHECK_THROWS_WITH_AS(scene::parse_json(R"({"a": {"b": 1, "b": 2}})", "f"), "f: a.b: the key is given twice",
                       Error);
  CHECK_THROWS_WITH_AS(scene::parse_json(R"([{"a": 1}, {"b": 1, "b": 2}])", "f"),
                       "f: [1].b: the key is given twice", Error);
  const std::string deep = std::string(100, '[') + std::string(100, ']');
  CHECK_THROWS_WITH_AS(scene::parse_json(deep, "f"), doctest::Contains("more than 64 deep"), Error);
  CHECK_THROWS_WITH_AS(scene::parse_json("{\"a\":\n 1,}", "f"), doctest::Contains("line 2"), Error);
  CHECK_THROWS_WITH_AS(scene::read_json("/nowhere/at.json"), "/nowhere/at.json: cannot be read", Error);
}

TEST_CASE("objects and lists are changed in place") {
  Value scene;
  scene["a"]["b"] = 1;
  scene["list"].push_back("x");
  CHECK(scene::to_json(scene) == R"({"a":{"b":1},"list":["x"]})");
  CHECK(scene.take("a") == Value::object("b", 1));
  CHECK(scene.take("a").is_null());
  CHECK(scene.size() == 1);
  CHECK(scene.find("list")->find("x") == nullptr);
}

TEST_CASE("messages name the path, and where a moved value was written") {
  const Value value = scene::parse_json(R"({"a": [{"b": "text"}]})", "test");
  CHECK_THROWS_WITH_AS(Node(value).at("a").items()[0].at("b").number(),
                       "a[0].b: must be a finite number, not \"text\"", Error);
  CHECK_THROWS_WITH_AS(Node(value).at("a").items()[0].at("c"), "a[0]: the key 'c' is missing", Error);
  Value moved = value;
  moved.find("a")->items()[0].set_origin("old[7]");
  CHECK_THROWS_WITH_AS(Node(moved).at("a").items()[0].at("b").truth(),
                       "old[7].b: must be true or false, not \"text\"", Error);
}

TEST_CASE("options are read by their fields") {
  const Options options = read(
      R"({"on": false, "count": 5, "bound": 2.5, "name": "x", "color": "red", "inner": {"share": 0.25}})");
  CHECK_FALSE(options.on);
  CHECK(options.count == 5);
  CHECK(options.bound == 2.5);
  CHECK(options.name == "x");
  CHECK(options.color == Color::red);
  CHECK(options.inner.share == 0.25);
  CHECK(error_of("{}") == "no error");
}

TEST_CASE("what an option cannot be is refused by its path") {
  CHECK(error_of(R"({"on": 1})") == "options.on: must be true or false, not 1");
  CHECK(error_of(R"({"count": 6})") == "options.count: must be a whole number from 1 to 5, not 6");
  CHECK(error_of(R"({"count": 1.5})") == "options.count: must be a whole number from 1 to 5, not 1.5");
  CHECK(error_of(R"({"bound": 1})") == "options.bound: must be a number > 1, not 1");
  CHECK(error_of(R"({"name": []})") == "options.name: must be a text, not a list of 0");
  CHECK(error_of(R"({"color": "blue"})") == "options.color: unknown 'blue'; there are red, green");
  CHECK(error_of(R"({"inner": {"share": 1}})") == "options.inner.share: must be a number > 0 and < 1, not 1");
  CHECK(error_of(R"({"inner": {"shore": 1}})") == "options.inner: unknown key 'shore'; there are share");
}

TEST_CASE("options are written so that they read back") {
  Options options;
  options.count = 4;
  options.inner.share = 0.125;
  const Value value = scene::options_value(options);
  CHECK_FALSE(value.has("bound"));  // JSON has no infinity, which is the default
  const Options again = read(scene::to_json(value));
  CHECK(again.count == 4);
  CHECK(again.inner.share == 0.125);
  CHECK(std::isinf(again.bound));
}

TEST_CASE("checks in code have the ranges of scenes") {
  Options options;
  CHECK_NOTHROW(check_ranges(options));
  options.inner.share = std::nan("");
  CHECK_THROWS_WITH_AS(check_ranges(options), "inner.share: must be a number > 0 and < 1, not nan",
                       OptionError);
  options = {};
  options.count = 0;
  CHECK_THROWS_WITH_AS(check_ranges(options), "count: must be a whole number from 1 to 5, not 0",
                       OptionError);
}

TEST_CASE("a schema and a table say what a field is") {
  Options options;
  const Value schema = scene::options_schema(option_fields(options));
  const Value& count = *schema.find("properties")->find("count");
  CHECK(scene::to_json(count) ==
        R"({"description":"How many","type":"integer","minimum":1,"maximum":5,"default":3})");
  CHECK(scene::to_json(*schema.find("properties")->find("bound")) ==
        R"json({"description":"At most (metres)","type":"number","exclusiveMinimum":1})json");
  CHECK(scene::options_table(option_fields(options), "p.") ==
        "| `p.on` | true, false | true | Whether |\n"
        "| `p.count` | a whole number from 1 to 5 | 3 | How many |\n"
        "| `p.bound` | a number > 1, metres | none | At most |\n"
        "| `p.name` | a text | `none` | A name |\n"
        "| `p.color` | `red`, `green` | `green` | Which |\n"
        "| `p.inner.share` | a number > 0 and < 1 | 0.5 | A share |\n");
}
