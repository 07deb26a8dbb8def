
#include <isostretch/core/base64.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/figures/html.hpp>
#include <isostretch/figures/utf8.hpp>

#include <algorithm>
#include <cctype>

namespace isostretch::figures::html {
namespace {

std::string cell(const std::string& name, const std::string& text, const Column& column) {
  return element(name, escaped(text), column.number ? "class=\"number\"" : "");
}

std::string head(const std::vector<Column>& columns) {
  std::string cells;
  for (const Column& column : columns) cells += cell("th", column.name, column);
  return block("thead", element("tr", cells));
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : valid_utf8(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:  // other control characters may not be in a page at all
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t')
          result += c;
        else
          result += "\uFFFD";
    }
  }
  return result;
}

std::string sentence(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

std::string element(const std::string& name, const std::string& content, const std::string& attributes) {
  std::string text = "<" + name;
  if (!attributes.empty()) text.append(1, ' ').append(attributes);
  return text.append(1, '>').append(content).append("</").append(name).append(1, '>');
}

std::string block(const std::string& name, const std::string& content, const std::string& attributes) {
  const bool ends_line = content.ends_with('\n');
  std::string lines(1, '\n');
  lines.append(content).append(ends_line ? "" : "\n");
  return element(name, lines, attributes).append(1, '\n');
}

std::string figure(std::string_view png, const std::string& description, const std::string& caption) {
  std::string image = "<img alt=\"";
  image.append(escaped(description))
      .append("\" src=\"data:image/png;base64,")
      .append(base64(png))
      .append("\">\n");
  return block("figure", image + element("figcaption", escaped(caption)));
}

std::string table(const std::vector<Column>& columns, const std::vector<std::vector<std::string>>& rows) {
  const bool named =
      std::any_of(columns.begin(), columns.end(), [](const Column& c) { return !c.name.empty(); });
  std::string body;
  for (const auto& row : rows) {
    std::string cells;
    for (std::size_t c = 0; c < row.size(); ++c)
      cells += cell("td", row[c], c < columns.size() ? columns[c] : Column{});
    body += element("tr", cells) + "\n";
  }
  return block("table", (named ? head(columns) : std::string()) + block("tbody", body));
}

std::string warnings(const std::vector<std::string>& texts) {
  std::string items;
  for (const std::string& text : texts) items += block("li", escaped(text));
  return items.empty() ? items : block("ul", items, "class=\"warnings\"");
}

std::string page(const std::string& title, const std::string& style, const std::string& body) {
  std::string head =
      "<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  head += element("title", escaped(title)) + "\n" + block("style", style);
  return "<!DOCTYPE html>\n" + block("html", block("head", head) + block("body", body), "lang=\"en\"");
}

}  // namespace isostretch::figures::html
