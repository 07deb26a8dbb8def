
#include <isostretch/figures/canvas.hpp>
#include <isostretch/figures/utf8.hpp>
#include "cairo_surface.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

#ifdef __SANITIZE_ADDRESS__
// Fontconfig keeps its tables of fonts until the end and never frees them; nobody needs to hear of it.
extern "C" {
const char* __lsan_default_suppressions();  // NOLINT: the sanitizer's names
const char* __lsan_default_options();       // NOLINT
const char* __lsan_default_suppressions() {
  return "leak:libfontconfig\n";
}
const char* __lsan_default_options() {
  return "print_suppressions=0";
}
}
#endif

namespace isostretch::figures {
namespace {

double share_before(Align align) {
  return align == Align::start ? 0.0 : align == Align::middle ? 0.5 : 1.0;
}

// Where a UTF-8 character begins, so that no text is cut inside one.
bool begins_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

// Lengths drawn and left out, in turns.
struct DashPattern {
  std::array<double, 4> lengths;
  int count;
};

const DashPattern& pattern_of(Dash dash) {
  static constexpr DashPattern patterns[] = {{{}, 0}, {{9, 4}, 2}, {{2.5, 2.5}, 2}, {{10, 3, 2.5, 3}, 4}};
  return patterns[static_cast<int>(dash)];
}

}  // namespace

struct Canvas::State {
  PictureFormat format = PictureFormat::png;
  std::string svg;  // so far; the surface appends to it
  CairoSurface surface;
  CairoContext context;

  cairo_t* cr() const { return context.get(); }

  void use(const LineStyle& style) const {
    cairo_set_source_rgba(cr(), style.color.r, style.color.g, style.color.b, style.opacity);
    cairo_set_line_width(cr(), style.width);
    const DashPattern& pattern = pattern_of(style.dash);
    cairo_set_dash(cr(), pattern.lengths.data(), pattern.count, 0);
  }
  void use(Color color) const { cairo_set_source_rgb(cr(), color.r, color.g, color.b); }
  void use(const TextStyle& style) const {
    cairo_select_font_face(cr(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr(), style.size);
    use(style.color);
  }
};

Canvas::Canvas(int width, int height, PictureFormat format) : state_(std::make_unique<State>()) {
  state_->format = format;
  state_->surface.reset(format == PictureFormat::png
                            ? cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)
                            : cairo_svg_surface_create_for_stream(append_bytes, &state_->svg, width, height));
  require_drawn(cairo_surface_status(state_->surface.get()));
  state_->context.reset(cairo_create(state_->surface.get()));
  cairo_set_line_join(state_->cr(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_source_rgb(state_->cr(), 1, 1, 1);
  cairo_paint(state_->cr());
}

Canvas::~Canvas() = default;

void Canvas::text(Point at, const std::string& text, const TextStyle& style) {
  cairo_t* cr = state_->cr();
  cairo_save(cr);
  state_->use(style);
  cairo_font_extents_t font;
  cairo_font_extents(cr, &font);
  cairo_translate(cr, at.x, at.y);
  if (style.vertical) cairo_rotate(cr, -std::numbers::pi / 2);
  const double left = -share_before(style.across) * text_width(text, style);
  // Digits and capitals reach 0.73 of the size above the line: centred on them, not on the font's box.
  const double base = style.down == Align::start    ? font.ascent
                      : style.down == Align::middle ? 0.365 * style.size
                                                    : -font.descent;
  cairo_move_to(cr, left, base);
  cairo_show_text(cr, valid_utf8(text).c_str());  // anything else it refuses
  cairo_new_path(cr);                             // or the next line would begin at the end of this text
  cairo_restore(cr);
}

double Canvas::text_width(const std::string& text, const TextStyle& style) {
  cairo_text_extents_t extents;
  state_->use(style);
  cairo_text_extents(state_->cr(), valid_utf8(text).c_str(), &extents);
  return extents.x_advance;
}

std::string Canvas::shortened(const std::string& text, double width, const TextStyle& style) {
  if (text_width(text, style) <= width) return text;
  for (std::size_t keep = text.size() / 2; keep > 0; --keep) {
    const std::size_t tail = text.size() - keep;
    if (!begins_character(text[keep]) || !begins_character(text[tail])) continue;
    const std::string shorter = text.substr(0, keep) + "…" + text.substr(tail);
    if (text_width(shorter, style) <= width) return shorter;
  }
  return "…";
}

void Canvas::line(Point from, Point to, const LineStyle& style) {
  polyline({from, to}, style);
}

void Canvas::polyline(const std::vector<Point>& points, const LineStyle& style) {
  state_->use(style);
  for (const Point& p : points) cairo_line_to(state_->cr(), p.x, p.y);
  cairo_stroke(state_->cr());
}

void Canvas::dot(Point at, double radius, Color color) {
  state_->use(color);
  cairo_arc(state_->cr(), at.x, at.y, radius, 0, 2 * std::numbers::pi);
  cairo_fill(state_->cr());
}

void Canvas::ring(Point at, double radius, const LineStyle& style) {
  state_->use(style);
  cairo_arc(state_->cr(), at.x, at.y, radius, 0, 2 * std::numbers::pi);
  cairo_stroke(state_->cr());
}

void Canvas::polygon(const std::vector<Point>& corners, Color color) {
  state_->use(color);
  for (const Point& p : corners) cairo_line_to(state_->cr(), p.x, p.y);
  cairo_close_path(state_->cr());
  cairo_fill(state_->cr());
}

void Canvas::fill(const Box& box, Color color) {
  state_->use(color);
  cairo_rectangle(state_->cr(), box.x, box.y, box.width, box.height);
  cairo_fill(state_->cr());
}

void Canvas::frame(const Box& box, const LineStyle& style) {
  state_->use(style);
  cairo_rectangle(state_->cr(), box.x, box.y, box.width, box.height);
  cairo_stroke(state_->cr());
}

void Canvas::image(const Raster& raster, Point corner) {
  const CairoSurface copy(cairo_image_surface_create(CAIRO_FORMAT_RGB24, raster.width(), raster.height()));
  require_drawn(cairo_surface_status(copy.get()));
  unsigned char* rows = cairo_image_surface_get_data(copy.get());
  const int stride = cairo_image_surface_get_stride(copy.get());
  const auto pixels = raster.pixels();
  for (int y = 0; y < raster.height(); ++y)
    std::memcpy(rows + static_cast<std::ptrdiff_t>(y) * stride,
                pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.width()),
                static_cast<std::size_t>(raster.width()) * sizeof(pixels[0]));
  cairo_surface_mark_dirty(copy.get());
  cairo_set_source_surface(state_->cr(), copy.get(), corner.x, corner.y);
  cairo_paint(state_->cr());
}

std::string Canvas::file() {
  require_drawn(cairo_status(state_->cr()));
  if (state_->format == PictureFormat::png) return png_bytes(state_->surface.get());
  cairo_surface_finish(state_->surface.get());
  require_drawn(cairo_surface_status(state_->surface.get()));
  return state_->svg;
}

}  // namespace isostretch::figures
