#pragma once

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace isostretch::app {

/// --check and --preview: ways to look at the input before anything is solved.
struct LookFlags {
  bool check = false;
  bool preview = false;
};

/// Declares --check, of the body, or of both poses where an app has two.
CLI::Option* declare_check(CLI::App& cli, bool& check, bool poses = false);
/// Declares both, which exclude each other.
void declare_look(CLI::App& cli, LookFlags& flags);

}  // namespace isostretch::app
