#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::comparison {

/// The numbers of a CSV file with a line of names on top, as apps write traces.
class NumberTable {
 public:
  /// Reads the text; lines that were cut off are left out.
  explicit NumberTable(const std::string& csv);

  /// Returns the number of rows, without that of the names.
  std::size_t rows() const { return rows_.size(); }
  /// Returns a number of a row; NaN where there is no such column, or no number.
  double at(std::size_t row, std::string_view name) const;

 private:
  std::vector<std::string> names_;
  std::vector<std::vector<double>> rows_;
};

}  // namespace isostretch::comparison
