#include "common/look_flags.hpp"

#include <CLI/CLI.hpp>

namespace isostretch::app {

CLI::Option* declare_check(CLI::App& cli, bool& check, bool poses) {
  return cli.add_flag("--check", check,
                      poses ? "Only look at the poses: print size, parts, groups, the worst element, what is "
                              "wrong, and whether they belong together, and exit; 3 if they cannot be used. "
                              "Needs no --out"
                            : "Only look at the body: print size, parts, groups, the worst element and what "
                              "is wrong, and exit; 3 if it cannot be used. Needs no --out and no handles");
}

void declare_look(CLI::App& cli, LookFlags& flags) {
  auto* check = declare_check(cli, flags.check);
  cli.add_flag("--preview", flags.preview,
               "Only look at the handles: print what each has and where it goes, and draw preview.png, "
               "without solving anything: to be sure of them before a long run")
      ->excludes(check);
}

}  // namespace isostretch::app
