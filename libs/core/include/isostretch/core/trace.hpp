#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// The course of a solve as a table: named columns, and a row for the start and for every iteration. All
/// methods give theirs in this form, so that one writer and one plot serve them all.
namespace isostretch {

/// The course of a solve as a table: named columns, a row for the start and for every iteration. All methods
/// give theirs in this form, so that one writer and one plot serve them all.
struct Trace {
  /// The names of the columns.
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;  ///< The rows, each with as many numbers as there are columns.

  /// Adds a column on the right. Throws Error unless there is a value for every row.
  void add_column(const std::string& name, const std::vector<double>& values);
  /// Adds a column on the left that has the same value in every row.
  void add_front_column(const std::string& name, double value);
  /// Adds the rows of another trace below. Throws Error unless both have the same columns.
  void append(const Trace& other);
  /// Returns the number of the column with that name. Throws Error when there is none.
  /// Returns the index of the column with this name. Throws Error if there is none.
  std::size_t column(const std::string& name) const;
};

/// Returns the trace as comma-separated values with a line of names on top. The numbers read back bit for
/// bit.
std::string to_csv(const Trace& trace);

}  // namespace isostretch
