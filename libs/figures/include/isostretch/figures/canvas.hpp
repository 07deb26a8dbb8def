#pragma once

#include <isostretch/figures/color_map.hpp>
#include <isostretch/figures/raster.hpp>

#include <memory>
#include <string>
#include <vector>

namespace isostretch::figures {

/// A point of a picture, in pixels.
struct Point {
  /// To the right.
  double x = 0, y = 0;  ///< Down.
};

/// A rectangle of a picture, in pixels.
struct Box {
  double x = 0;       ///< Left side.
  double y = 0;       ///< Upper side.
  double width = 0;   ///< Extent to the right.
  double height = 0;  ///< Extent down.
  /// Returns x of the right side.
  double right() const { return x + width; }
  /// Returns y of the lower side.
  double bottom() const { return y + height; }
};

/// The alignment of text to a point.
enum class Align { start, middle, end };

/// The look of text.
struct TextStyle {
  double size = 13;               ///< Height of the font, in pixels.
  Color color{0.15, 0.15, 0.15};  ///< Colour.
  bool bold = false;              ///< Whether the font is bold.
  Align across = Align::start;    ///< Alignment along the line of text.
  /// Alignment across the line of text; with start, the text hangs below the point.
  Align down = Align::middle;
  bool vertical = false;  ///< Whether it is read from bottom to top.
};

/// The pattern of a line.
enum class Dash { solid, dashed, dotted, dash_dotted };

/// The look of a line.
struct LineStyle {
  Color color{0.15, 0.15, 0.15};  ///< Colour.
  double width = 1;               ///< Width, in pixels.
  double opacity = 1;             ///< Opacity, 0 to 1.
  Dash dash = Dash::solid;        ///< Pattern.
};

/// The format of a picture's file.
enum class PictureFormat { png, svg };

/// A picture in memory, white at the start, drawn with cairo: antialiased pixels, or shapes of any size.
class Canvas {
 public:
  /// Makes a white picture of a size in pixels.
  Canvas(int width, int height, PictureFormat format = PictureFormat::png);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Writes text at a point.
  void text(Point at, const std::string& text, const TextStyle& style = {});
  /// Returns the width of text, in pixels.
  double text_width(const std::string& text, const TextStyle& style = {});
  /// Returns the text, with its middle cut out where it is wider than `width` pixels.
  std::string shortened(const std::string& text, double width, const TextStyle& style = {});

  /// Draws a straight line.
  void line(Point from, Point to, const LineStyle& style = {});
  /// Draws a line through points.
  void polyline(const std::vector<Point>& points, const LineStyle& style);
  /// Draws a filled circle.
  void dot(Point at, double radius, Color color);
  /// Draws a circle.
  void ring(Point at, double radius, const LineStyle& style);
  /// Fills a polygon.
  void polygon(const std::vector<Point>& corners, Color color);
  /// Fills a rectangle.
  void fill(const Box& box, Color color);
  /// Draws the outline of a rectangle.
  void frame(const Box& box, const LineStyle& style = {});
  /// Draws a raster with its upper left corner at a point.
  void image(const Raster& raster, Point corner);

  /// Returns the picture as the bytes of a file of its format; nothing can be drawn any more.
  std::string file();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace isostretch::figures
