#include "common/option_flags.hpp"

#include "common/validators.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/numbers.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/scene/scene_file.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::app {
namespace {

using scene::Value;

std::string flag_name(std::string key) {
  std::replace(key.begin(), key.end(), '_', '-');
  return key;
}

// The value that a path leads to, with objects on the way as they are needed.
Value& place_of(const std::vector<std::string>& path, Value& scene, const std::string& who) {
  Value* place = &scene;
  for (const std::string& key : path) {
    if (!place->is_object() && !place->is_null())
      throw Error(ErrorKind::misuse,
                  who + ": there is something else in the scene where '" + key + "' should go");
    place = &(*place)[key];
  }
  return *place;
}

std::string type_name(const OptionField& option) {
  if (std::holds_alternative<ChoiceSlot>(option.slot)) return "NAME";
  if (*option.field.unit != '\0') {
    std::string unit = option.field.unit;
    std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return std::toupper(c); });
    return unit;
  }
  return std::holds_alternative<int*>(option.slot) ? "N" : "X";
}

}  // namespace

CLI::Option* OptionFlags::add(CLI::App& cli, const std::string& name, const std::string& help, Flag flag) {
  Flag& kept = flags_.emplace_back(std::move(flag));
  CLI::Option* option =
      kept.kind == Kind::truth ? cli.add_flag(name, help) : cli.add_option(name, kept.text, help);
  kept.option = option;
  return option;
}

void OptionFlags::declare(CLI::App& cli, const std::vector<OptionField>& fields, const std::string& path) {
  for (const OptionField& option : fields) {
    if (option.field.expert) continue;
    const std::string own = path.empty() ? option.field.name : path + "." + option.field.name;
    if (const auto* inner = std::get_if<std::vector<OptionField>>(&option.slot))
      declare(cli, *inner, own);
    else
      declare_field(cli, option, own);
  }
}

void OptionFlags::declare_field(CLI::App& cli, const OptionField& option, const std::string& path) {
  const Field& field = option.field;
  const std::string name = flag_name(field.name);
  Flag flag{split(path, '.'), Kind::number};
  if (const auto* truth = std::get_if<bool*>(&option.slot)) {
    flag.kind = Kind::truth;
    flag.opposite = **truth;
    add(cli, (flag.opposite ? "--no-" : "--") + name,
        flag.opposite ? std::string("Do not: ") + field.help : field.help, flag);
    return;
  }
  if (const auto* choice = std::get_if<ChoiceSlot>(&option.slot)) {
    flag.kind = Kind::text;
    add(cli, "--" + name, std::string(field.help) + ": " + listed(choice->names()), flag)
        ->check(one_of(choice->names))
        ->type_name("NAME")
        ->default_str(choice->get());
    return;
  }
  const bool whole = std::holds_alternative<int*>(option.slot);
  const double now = whole ? **std::get_if<int*>(&option.slot) : **std::get_if<double*>(&option.slot);
  CLI::Option* added = add(cli, "--" + name, field.help, flag);
  added->check(in_range(field.range, whole))->type_name(type_name(option));
  if (std::isfinite(now)) added->default_str(to_text(now));
}

CLI::Option* OptionFlags::declare_key(CLI::App& cli, const std::string& key, const std::string& fallback) {
  const Value schema = *scene::scene_schema().find("properties")->find(key);
  Flag flag{{key}, Kind::number};
  std::string help = schema.find("description")->text();
  CLI::Option* option = nullptr;
  if (const Value* names = schema.find("enum")) {
    std::vector<std::string> texts;
    for (const Value& name : names->items()) texts.push_back(name.text());
    flag.kind = Kind::text;
    option = add(cli, "--" + flag_name(key), help + ": " + listed(texts), flag);
    option->check(one_of(texts))->type_name("NAME");
  } else {
    option = add(cli, "--" + flag_name(key), help, flag);
    option->check(in_range(between(schema.find("minimum")->number(), schema.find("maximum")->number()), true))
        ->type_name("N");
  }
  if (const Value* value = schema.find("default"))
    option->default_str(value->is_text() ? value->text() : to_json(*value));
  else if (!fallback.empty())
    option->default_str(fallback);
  return option;
}

void OptionFlags::declare_set(CLI::App& cli) {
  cli.add_option("--set", settings_,
                 "Set a key of the scene by its path, such as newton.armijo=1e-3; may be repeated. "
                 "share/isostretch/scene.schema.json describes all keys")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
}

void OptionFlags::add_to(Value& scene) const {
  for (const Flag& flag : flags_)
    if (flag.option->count() > 0) add_text(flag, scene);
  for (const std::string& setting : settings_) {
    const std::size_t equals = setting.find('=');
    if (equals == 0 || equals == std::string::npos)
      throw Error(ErrorKind::misuse, "--set: '" + setting + "' is not of the form key=value");
    const std::string text = setting.substr(equals + 1);
    Value value = text;  // names need no quotes
    try {
      value = scene::parse_json(text, "--set");
    } catch (const Error&) {
    }
    place_of(split(setting.substr(0, equals), '.'), scene, "--set " + setting) = value;
  }
}

void OptionFlags::add_text(const Flag& flag, Value& scene) const {
  Value& place = place_of(flag.path, scene, flag.option->get_name());
  if (flag.kind == Kind::truth)
    place = !flag.opposite;
  else if (flag.kind == Kind::number)
    place = *finite_number(flag.text);
  else
    place = flag.text;
}

namespace {

// Puts the new name into words[i], where the old one stands there, alone or with its value.
bool rename(const RenamedFlag& flag, std::vector<std::string>& words, std::size_t i) {
  const std::vector<std::string> from = split(flag.from, ' ');
  const std::string joined = from.size() > 1 ? from[0] + "=" + from[1] : std::string();
  if (from.size() > 1) {
    const bool apart = words[i] == from[0] && i + 1 < words.size() && words[i + 1] == from[1];
    if (!apart && words[i] != joined) return false;
    if (apart) words.erase(words.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    words[i] = flag.to;
    return true;
  }
  const bool with_value = words[i].starts_with(flag.from + "=");
  if (words[i] != flag.from && !with_value) return false;
  words[i] = flag.to + (with_value ? words[i].substr(flag.from.size()) : "");
  return true;
}

}  // namespace

std::vector<std::string> with_new_names(int argc, const char* const* argv,
                                        const std::vector<RenamedFlag>& renamed,
                                        std::vector<std::string>& notices) {
  std::vector<std::string> words(argv, argv + argc);
  for (std::size_t i = 1; i < words.size() && words[i] != "--"; ++i)
    for (const RenamedFlag& flag : renamed)
      if (rename(flag, words, i)) {
        notices.push_back("option " + flag.from +
                          (flag.to.empty() ? " is the default now" : " is " + flag.to + " now"));
        break;
      }
  std::erase(words, std::string());
  return words;
}

}  // namespace isostretch::app
