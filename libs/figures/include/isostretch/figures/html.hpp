#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::figures::html {

/// Returns text as a browser shows it unchanged, also between the quotes of an attribute.
std::string escaped(std::string_view text);

/// Returns the text with a capital letter at its start and a full stop at its end.
std::string sentence(std::string text);

/// Returns `<name attributes>content</name>`; attributes and content are taken as they are.
std::string element(const std::string& name, const std::string& content, const std::string& attributes = {});
/// Returns `<name attributes>content</name>` on lines of its own; attributes and content are taken as they
/// are.
std::string block(const std::string& name, const std::string& content, const std::string& attributes = {});

/// Returns a PNG inside the page itself, with its caption below; the texts are escaped.
std::string figure(std::string_view png, const std::string& description, const std::string& caption);

/// A column of a table.
struct Column {
  std::string name;     ///< Text of the head.
  bool number = false;  ///< Whether cells are numbers, set to the right.
};

/// Returns a table. Cells are text and are escaped. Without names of columns there is no head; without
/// columns cells are text to the left.
std::string table(const std::vector<Column>& columns, const std::vector<std::vector<std::string>>& rows);

/// Returns a list of texts in the colour of warnings; the texts are escaped. Empty where there are none.
std::string warnings(const std::vector<std::string>& texts);

/// Returns a whole page that needs nothing else; title is text, style and body are taken as they are.
std::string page(const std::string& title, const std::string& style, const std::string& body);

}  // namespace isostretch::figures::html
