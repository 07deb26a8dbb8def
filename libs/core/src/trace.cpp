#include <isostretch/core/error.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/core/trace.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch {

void Trace::add_column(const std::string& name, const std::vector<double>& values) {
  if (values.size() != rows.size())
    throw Error(ErrorKind::misuse, "trace: " + std::to_string(values.size()) + " values of '" + name +
                                       "' for " + std::to_string(rows.size()) + " rows");
  columns.push_back(name);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(values[i]);
}

void Trace::add_front_column(const std::string& name, double value) {
  columns.insert(columns.begin(), name);
  for (auto& row : rows) row.insert(row.begin(), value);
}

void Trace::append(const Trace& other) {
  if (columns.empty() && rows.empty()) columns = other.columns;
  if (columns != other.columns)
    throw Error(ErrorKind::misuse, "trace: rows of other columns cannot be added");
  rows.insert(rows.end(), other.rows.begin(), other.rows.end());
}

std::size_t Trace::column(const std::string& name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) throw Error(ErrorKind::misuse, "trace: there is no column '" + name + "'");
  return static_cast<std::size_t>(found - columns.begin());
}

namespace {

// Counts as counts: the shortest text of 100000 is 1e+05.
std::string number_text(double value) {
  constexpr double largest_count = 1e15;
  if (value == std::floor(value) && std::abs(value) < largest_count && !(value == 0 && std::signbit(value)))
    return std::to_string(static_cast<long long>(value));
  return to_text(value);
}

}  // namespace

std::string to_csv(const Trace& trace) {
  std::string text;
  for (const std::string& column : trace.columns) text.append(text.empty() ? "" : ",").append(column);
  text += '\n';
  for (const auto& row : trace.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) text.append(i > 0 ? "," : "").append(number_text(row[i]));
    text += '\n';
  }
  return text;
}

}  // namespace isostretch
