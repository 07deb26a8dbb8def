#include <isostretch/comparison/number_table.hpp>
#include <isostretch/core/numbers.hpp>

#include <algorithm>
#include <limits>
#include <sstream>

namespace isostretch::comparison {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

}  // namespace

NumberTable::NumberTable(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  if (!std::getline(lines, line)) return;
  names_ = split(line, ',');
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = split(line, ',');
    if (cells.size() != names_.size()) continue;
    auto& row = rows_.emplace_back();
    for (const std::string& cell : cells) row.push_back(finite_number(cell).value_or(none));
  }
}

double NumberTable::at(std::size_t row, std::string_view name) const {
  const auto column = std::find(names_.begin(), names_.end(), name);
  return column == names_.end() ? none : rows_[row][static_cast<std::size_t>(column - names_.begin())];
}

}  // namespace isostretch::comparison
