#pragma once

#include <isostretch/figures/canvas.hpp>

#include <string>
#include <vector>

namespace isostretch::figures {

/// One quantity of every method against one other; a curve a method, empty where there is none.
struct ComparisonPanel {
  std::string title;
  std::string x_label;
  bool logarithmic_x = false, logarithmic_y = false;
  /// In units of the quantities. On logarithmic axes values that are not positive are drawn at the lower
  /// edge.
  std::vector<std::vector<Point>> curves;
  bool counts = true;            ///< a linear y axis has whole numbers
  double lowest_y = 0;           ///< a logarithmic y axis goes no further down
  std::vector<double> levels{};  ///< of y, drawn across
};

/// Panels of equal size in rows of `columns`, and the methods' names with their colours, dashes and marks on
/// the right, but for empty names; as the bytes of a file. A ring marks where a curve ends.
std::string draw_comparison(const std::string& title, const std::string& subtitle,
                            const std::vector<std::string>& names, const std::vector<ComparisonPanel>& panels,
                            int columns, PictureFormat format = PictureFormat::png);

}  // namespace isostretch::figures
