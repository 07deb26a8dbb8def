#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace isostretch::app {

/// Lays --help out for a terminal of 80 columns: options by group, what an option takes and its default,
/// descriptions wrapped with the indentation that their lines have.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_description(const CLI::App* app) const override;
  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override;
};

/// Breaks lines between words so that none is longer than `width` where a word is not. Lines that follow a
/// break are indented as the line was, by `indent` more columns.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent = 0);

/// Returns the lines of examples for the end of --help.
std::string example_help(const std::vector<std::string>& examples);

}  // namespace isostretch::app
