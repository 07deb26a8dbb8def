#pragma once

#include <isostretch/figures/color_map.hpp>
#include <isostretch/figures/raster.hpp>

#include <memory>
#include <string>
#include <vector>

namespace isostretch::figures {

struct Point {
  double x = 0, y = 0;
};

/// x to the right, y down, in pixels.
struct Box {
  double x = 0, y = 0, width = 0, height = 0;
  double right() const { return x + width; }
  double bottom() const { return y + height; }
};

enum class Align { start, middle, end };

struct TextStyle {
  double size = 13;
  Color color{0.15, 0.15, 0.15};
  bool bold = false;
  Align across = Align::start;  ///< along the line of text
  Align down = Align::middle;   ///< start: the text hangs below the point
  bool vertical = false;        ///< read from bottom to top
};

enum class Dash { solid, dashed, dotted, dash_dotted };

struct LineStyle {
  Color color{0.15, 0.15, 0.15};
  double width = 1;
  double opacity = 1;
  Dash dash = Dash::solid;
};

enum class PictureFormat { png, svg };

/// A picture in memory, white at the start, drawn with cairo: antialiased pixels, or shapes of any size.
class Canvas {
 public:
  Canvas(int width, int height, PictureFormat format = PictureFormat::png);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  void text(Point at, const std::string& text, const TextStyle& style = {});
  double text_width(const std::string& text, const TextStyle& style = {});
  /// The text with its middle cut out where it is wider than that.
  std::string shortened(const std::string& text, double width, const TextStyle& style = {});

  void line(Point from, Point to, const LineStyle& style = {});
  void polyline(const std::vector<Point>& points, const LineStyle& style);
  void dot(Point at, double radius, Color color);
  void ring(Point at, double radius, const LineStyle& style);
  void polygon(const std::vector<Point>& corners, Color color);
  void fill(const Box& box, Color color);
  void frame(const Box& box, const LineStyle& style = {});
  void image(const Raster& raster, Point corner);

  /// The picture as the bytes of a file of its format; nothing can be drawn any more.
  std::string file();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace isostretch::figures
