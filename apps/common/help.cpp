#include "common/help.hpp"

#include <isostretch/core/numbers.hpp>

#include <algorithm>

namespace isostretch::app {
namespace {

constexpr std::size_t columns = 80, name_columns = 26;

std::string wrapped_line(const std::string& line, std::size_t width, std::size_t indent) {
  const std::size_t own = std::min(line.find_first_not_of(' '), line.size());
  std::string result, current(own, ' ');
  bool empty = true;
  for (const std::string& word : split(line.substr(own), ' ')) {
    if (!empty && current.size() + 1 + word.size() > width) {
      result += current + "\n";
      current.assign(own + indent, ' ');
      empty = true;
    }
    if (!empty) current += ' ';
    current += word;
    empty = false;
  }
  return result + current;
}

std::string names_of(const CLI::Option& option, bool is_positional) {
  std::string names = option.get_name(is_positional, !is_positional);
  // What a flag stands for that is given without a value, --weld{0.0}, is nothing to type.
  if (const std::size_t brace = names.find('{'); brace != std::string::npos)
    names.erase(brace, names.find('}', brace) + 1 - brace);
  if (option.get_type_size() != 0) names += " " + option.get_type_name();
  return names;
}

std::string joined_names(const std::set<CLI::Option*>& options) {
  std::string names;
  for (const CLI::Option* option : options) names += (names.empty() ? "" : ", ") + option->get_name();
  return names;
}

std::string notes_of(const CLI::Option& option) {
  std::vector<std::string> notes;
  if (option.get_required()) notes.emplace_back("required");
  if (!option.get_default_str().empty()) notes.push_back("default: " + option.get_default_str());
  if (!option.get_needs().empty()) notes.push_back("needs " + joined_names(option.get_needs()));
  if (!option.get_excludes().empty()) notes.push_back("not with " + joined_names(option.get_excludes()));
  std::string text;
  for (const std::string& note : notes) text += (text.empty() ? " (" : "; ") + note;
  return text.empty() ? text : text + ")";
}

}  // namespace

std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  std::string result;
  for (const std::string& line : split(text, '\n'))
    result += (result.empty() ? "" : "\n") + wrapped_line(line, width, indent);
  return result;
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
  std::string text = "  " + names_of(*option, is_positional);
  std::string description = option->get_description();
  while (!description.empty() && description.back() == '\n') description.pop_back();
  bool beside = text.size() + 2 <= name_columns;
  for (const std::string& line :
       split(wrapped(description + notes_of(*option), columns - name_columns), '\n')) {
    if (!beside) text += "\n";
    text += std::string(beside ? name_columns - text.size() : name_columns, ' ') + line;
    beside = false;
  }
  return text + "\n";
}

// Groups are set apart by one empty line, not by two.
std::string HelpFormatter::make_group(std::string group, bool is_positional,
                                      std::vector<const CLI::Option*> options) const {
  std::string text = is_positional ? "\n" + group + ":\n" : group + ":\n";
  for (const CLI::Option* option : options) text += make_option(option, is_positional);
  return text;
}

std::string HelpFormatter::make_description(const CLI::App* app) const {
  return wrapped(app->get_description(), columns) + "\n";
}

std::string example_help(const std::vector<std::string>& examples) {
  if (examples.empty()) return {};
  std::string text = examples.size() == 1 ? "Example:\n" : "Examples:\n";
  for (const std::string& example : examples) text += wrapped("  " + example, columns - 2, 4) + "\n";
  return text + "\n";
}

}  // namespace isostretch::app
