#pragma once

#include <isostretch/core/option_fields.hpp>
#include <isostretch/scene/value.hpp>

#include <deque>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace isostretch::app {

/// Flags that set keys of a scene, made of what options and the schema say of themselves: --max-iterations
/// sets "max_iterations". Keys without a flag are set by --set.
class OptionFlags {
 public:
  /// Declares a flag for every field that is not for experts. `path` is where the options stand in a scene,
  /// such as "newton".
  void declare(CLI::App& cli, const std::vector<OptionField>& fields, const std::string& path);
  /// Declares the flag of a key that the schema of scenes describes. `fallback` is the default that --help
  /// shows, unless the schema has one.
  CLI::Option* declare_key(CLI::App& cli, const std::string& key, const std::string& fallback = {});
  /// Declares --set, for every key there is.
  void declare_set(CLI::App& cli);

  /// Puts what was given into the scene. Throws Error naming --set where it is malformed or another kind of
  /// value is in the way.
  void add_to(scene::Value& scene) const;

 private:
  enum class Kind { text, number, truth };
  struct Flag {
    std::vector<std::string> path;
    Kind kind = Kind::text;
    bool opposite = false;  ///< of a truth: given, it is false
    std::string text = {};
    const CLI::Option* option = nullptr;
  };

  void declare_field(CLI::App& cli, const OptionField& field, const std::string& path);
  CLI::Option* add(CLI::App& cli, const std::string& name, const std::string& help, Flag flag);
  void add_text(const Flag& flag, scene::Value& scene) const;

  std::deque<Flag> flags_;
  std::vector<std::string> settings_;
};

/// A flag that is called otherwise now. It goes on to work, with a notice.
struct RenamedFlag {
  std::string from;  ///< --flag, or "--flag value" of one value only
  std::string to;    ///< --flag, or --flag=value; empty: there is nothing to be said any more
};

/// Returns the arguments with old names of flags replaced by the new ones, in `notices` a line for each.
std::vector<std::string> with_new_names(int argc, const char* const* argv,
                                        const std::vector<RenamedFlag>& renamed,
                                        std::vector<std::string>& notices);

}  // namespace isostretch::app
