#include "common/scene_input.hpp"

#include <CLI/CLI.hpp>

#include <iostream>

namespace isostretch::app {

void take_scene_names(CLI::Option& option, const std::vector<EmbeddedScene>& embedded) {
  option.transform(CLI::Validator(
      [&embedded](std::string& input) {
        if (!scene::is_file(input) && !is_scene_file(input) &&
            scene::embedded_scene(input, embedded) != nullptr)
          input += ".json";
        return std::string();
      },
      ""));
}

void declare_scene_list(CLI::App& cli, const std::vector<EmbeddedScene>& embedded) {
  cli.add_flag_callback(
         "--list-scenes",
         [&embedded] {
           std::cout << scene::scene_list(embedded) << std::flush;
           throw CLI::Success{};
         },
         "List the scenes that come with the program and what they show, and exit")
      ->trigger_on_parse();
}

}  // namespace isostretch::app
