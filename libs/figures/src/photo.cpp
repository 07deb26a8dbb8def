
#include <isostretch/figures/photo.hpp>
#include "cairo_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>

namespace isostretch::figures {
namespace {

constexpr int largest_side = 32767;  // of a cairo surface

cairo_status_t read_bytes(void* stream, unsigned char* data, unsigned int size) {
  auto& in = *static_cast<std::ifstream*>(stream);
  in.read(reinterpret_cast<char*>(data), size);
  return in ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_READ_ERROR;
}

CairoSurface decoded(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!std::filesystem::is_regular_file(file) || !in) throw Error(file.string() + ": cannot be read");
  CairoSurface surface(cairo_image_surface_create_from_png_stream(read_bytes, &in));
  if (cairo_surface_status(surface.get()) !=
      CAIRO_STATUS_SUCCESS)  // which one says little: it depends on libpng
    throw Error(file.string() + ": is no PNG picture, or one that is damaged or too large");
  return surface;
}

CairoSurface blank(int width, int height) {
  CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
  require_drawn(cairo_surface_status(surface.get()));
  return surface;
}

// Whatever it holds, as 8 bits a channel.
CairoSurface with_alpha(cairo_surface_t* any, int width, int height) {
  CairoSurface result = blank(width, height);
  const CairoContext context(cairo_create(result.get()));
  cairo_set_source_surface(context.get(), any, 0, 0);
  cairo_set_operator(context.get(), CAIRO_OPERATOR_SOURCE);
  cairo_paint(context.get());
  require_drawn(cairo_status(context.get()));
  cairo_surface_flush(result.get());
  return result;
}

Premultiplied channels(std::uint32_t pixel) {
  Premultiplied result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = static_cast<double>((pixel >> (8 * i)) & 0xFFU);
  return result;
}

}  // namespace

Photo::Photo(int width, int height)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0U) {}

Premultiplied Photo::at(double x, double y) const {
  const double u = std::clamp(x - 0.5, 0.0, width_ - 1.0), v = std::clamp(y - 0.5, 0.0, height_ - 1.0);
  const int i = std::min(static_cast<int>(u), std::max(width_ - 2, 0));
  const int j = std::min(static_cast<int>(v), std::max(height_ - 2, 0));
  const double s = u - i, t = v - j;
  Premultiplied sum{};
  const auto add = [&](int column, int row, double weight) {
    if (weight == 0) return;  // beyond the edge of a picture one pixel wide
    const Premultiplied c = channels(pixel(column, row));
    for (std::size_t k = 0; k < 4; ++k) sum[k] += weight * c[k];
  };
  add(i, j, (1 - s) * (1 - t));
  add(i + 1, j, s * (1 - t));
  add(i, j + 1, (1 - s) * t);
  add(i + 1, j + 1, s * t);
  return sum;
}

std::string Photo::png() const {
  if (width_ > largest_side || height_ > largest_side)
    throw Error("cannot draw the picture: it is too large");
  const CairoSurface surface = blank(width_, height_);
  unsigned char* rows = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int row = 0; row < height_; ++row)
    std::memcpy(rows + static_cast<std::ptrdiff_t>(row) * stride, pixels_.data() + index(0, row),
                static_cast<std::size_t>(width_) * sizeof(pixels_[0]));
  cairo_surface_mark_dirty(surface.get());
  return png_bytes(surface.get());
}

Photo read_photo(const std::filesystem::path& file) {
  const CairoSurface original = decoded(file);
  Photo photo(cairo_image_surface_get_width(original.get()), cairo_image_surface_get_height(original.get()));
  const CairoSurface copy = with_alpha(original.get(), photo.width(), photo.height());
  const unsigned char* rows = cairo_image_surface_get_data(copy.get());
  const int stride = cairo_image_surface_get_stride(copy.get());
  for (int row = 0; row < photo.height(); ++row)
    for (int column = 0; column < photo.width(); ++column) {
      std::uint32_t value = 0;
      std::memcpy(&value,
                  rows + static_cast<std::ptrdiff_t>(row) * stride + 4 * static_cast<std::ptrdiff_t>(column),
                  sizeof value);
      photo.set_pixel(column, row, value);
    }
  return photo;
}

}  // namespace isostretch::figures
