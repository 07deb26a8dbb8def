#include <isostretch/scene/option_values.hpp>

#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>

#include <cmath>

namespace isostretch::scene {
namespace {

constexpr double largest_whole = std::numeric_limits<int>::max();

// For std::visit.
template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

void read(const Node& node, const OptionField& option) {
  const Range& range = option.field.range;
  std::visit(Overloaded{[&](bool* value) { *value = node.truth(); },
                        [&](int* value) {
                          *value = node.whole(static_cast<int>(std::max(range.lowest, -largest_whole)),
                                              static_cast<int>(std::min(range.highest, largest_whole)));
                        },
                        [&](double* value) { *value = node.number(range); },
                        [&](std::string* value) { *value = node.text(); },
                        [&](const ChoiceSlot& choice) {
                          node.require_one_of(choice.names());
                          choice.set(node.text());
                        },
                        [&](const std::vector<OptionField>& inner) { read_options(node, inner); }},
             option.slot);
}

Value value_of(const OptionSlot& slot) {
  return std::visit(Overloaded{[](const ChoiceSlot& choice) { return Value(choice.get()); },
                               [](const std::vector<OptionField>& inner) { return options_value(inner); },
                               [](const auto* value) { return Value(*value); }},
                    slot);
}

bool is_infinite(const Value& value) {
  return value.is_number() && !std::isfinite(value.number());
}

void add_range(const Range& range, Value& schema) {
  if (range.lowest > std::numeric_limits<double>::lowest())
    schema[range.without_lowest ? "exclusiveMinimum" : "minimum"] = range.lowest;
  if (range.highest < std::numeric_limits<double>::max())
    schema[range.without_highest ? "exclusiveMaximum" : "maximum"] = range.highest;
}

Value schema_of(const OptionField& option) {
  if (const auto* inner = std::get_if<std::vector<OptionField>>(&option.slot)) {
    Value schema = options_schema(*inner);
    schema["description"] = option.field.help;
    return schema;
  }
  Value schema = Value::object();
  std::string help = option.field.help;
  if (*option.field.unit != '\0') help.append(" (").append(option.field.unit).append(")");
  schema["description"] = help;
  std::visit(Overloaded{[&](const bool*) { schema["type"] = "boolean"; },
                        [&](const std::string*) { schema["type"] = "string"; },
                        [&](const int*) {
                          schema["type"] = "integer";
                          add_range(option.field.range, schema);
                        },
                        [&](const double*) {
                          schema["type"] = "number";
                          add_range(option.field.range, schema);
                        },
                        [&](const ChoiceSlot& choice) {
                          const std::vector<std::string> names = choice.names();
                          schema["enum"] = Value::list({names.begin(), names.end()});
                        },
                        [](const std::vector<OptionField>&) {}},
             option.slot);
  if (const Value now = value_of(option.slot); !is_infinite(now)) schema["default"] = now;
  return schema;
}

// As a cell of a table in Markdown.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : text) result.append(c == '|' ? "\\|" : std::string(1, c));
  return result;
}

std::string quoted(std::vector<std::string> names) {
  for (std::string& name : names) name = std::string("`").append(name).append("`");
  return listed(names);
}

// What a field may be, in words.
std::string kind_of(const OptionField& option) {
  return std::visit(Overloaded{[](const bool*) { return std::string("true, false"); },
                               [](const std::string*) { return std::string("a text"); },
                               [&](const int*) { return option.field.range.in_words(true); },
                               [&](const double*) { return option.field.range.in_words(false); },
                               [](const ChoiceSlot& choice) { return quoted(choice.names()); },
                               [](const std::vector<OptionField>&) { return std::string("an object"); }},
                    option.slot);
}

std::string default_of(const OptionField& option) {
  const Value value = value_of(option.slot);
  if (value.is_text()) return std::string("`").append(value.text()).append("`");
  return is_infinite(value) ? "none" : to_json(value);
}

}  // namespace

void read_options(const Node& object, const std::vector<OptionField>& fields,
                  const std::vector<std::string>& others) {
  std::vector<std::string> keys = others;
  for (const OptionField& option : fields) keys.emplace_back(option.field.name);
  object.only(keys);
  for (const OptionField& option : fields)
    if (const auto node = object.find(option.field.name)) read(*node, option);
}

Value options_value(const std::vector<OptionField>& fields) {
  Value object = Value::object();
  for (const OptionField& option : fields)
    if (Value value = value_of(option.slot); !is_infinite(value))
      object[option.field.name] = std::move(value);
  return object;
}

Value options_schema(const std::vector<OptionField>& fields) {
  Value schema = Value::object("type", "object");
  schema["additionalProperties"] = false;
  Value& properties = schema["properties"] = Value::object();
  for (const OptionField& option : fields) properties[option.field.name] = schema_of(option);
  return schema;
}

std::string options_table(const std::vector<OptionField>& fields, const std::string& prefix) {
  std::string table;
  for (const OptionField& option : fields) {
    const std::string path = prefix + option.field.name;
    if (const auto* inner = std::get_if<std::vector<OptionField>>(&option.slot)) {
      table += options_table(*inner, path + ".");
      continue;
    }
    table.append("| `").append(path).append("` | ").append(kind_of(option));
    if (*option.field.unit != '\0') table.append(", ").append(option.field.unit);
    table.append(" | ")
        .append(default_of(option))
        .append(" | ")
        .append(cell(option.field.help))
        .append(" |\n");
  }
  return table;
}

}  // namespace isostretch::scene
