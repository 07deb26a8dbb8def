#pragma once

#include <isostretch/figures/canvas.hpp>

#include <string>
#include <vector>

namespace isostretch::figures {

/// A plot of one quantity of every method against another, a curve per method, empty where there is none.
struct ComparisonPanel {
  std::string title;    ///< Title above the plot.
  std::string x_label;  ///< Name of the quantity along x.
  /// Whether x is logarithmic.
  bool logarithmic_x = false, logarithmic_y = false;  ///< Whether y is logarithmic.
  /// Points of the curves, in units of the quantities. On logarithmic axes values that are not positive are
  /// drawn at the lower edge.
  std::vector<std::vector<Point>> curves;
  bool counts = true;            ///< Whether a linear y axis has whole numbers.
  double lowest_y = 0;           ///< Value below which a logarithmic y axis does not go.
  std::vector<double> levels{};  ///< Values of y that are drawn across.
};

/// Returns panels of equal size in rows of `columns` as the bytes of a file, with the methods' names, but for
/// empty ones, and their colours, dashes and marks on the right. A ring marks where a curve ends.
std::string draw_comparison(const std::string& title, const std::string& subtitle,
                            const std::vector<std::string>& names, const std::vector<ComparisonPanel>& panels,
                            int columns, PictureFormat format = PictureFormat::png);

}  // namespace isostretch::figures
