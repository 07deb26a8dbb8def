#include "cairo_surface.hpp"

#include <png.h>

#include <cstdint>
#include <cstring>
#include <vector>

namespace isostretch::figures {

namespace {

// cairo has a pixel as 0x00RRGGBB.
std::vector<png_byte> rgb_rows(cairo_surface_t* surface, std::size_t width, std::size_t height) {
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  const unsigned char* const data = cairo_image_surface_get_data(surface);
  std::vector<std::uint32_t> pixels(width);
  std::vector<png_byte> rows(3 * width * height);
  png_byte* to = rows.data();
  for (std::size_t y = 0; y < height; ++y) {
    std::memcpy(pixels.data(), data + y * stride, width * sizeof(pixels[0]));
    for (const std::uint32_t pixel : pixels)
      for (const int shift : {16, 8, 0}) *to++ = static_cast<png_byte>(pixel >> shift);
  }
  return rows;
}

}  // namespace

cairo_status_t append_bytes(void* text, const unsigned char* data, unsigned int size) {
  try {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
  } catch (...) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

// cairo's own writer tries every filter on every row and compresses harder, which takes longer than drawing;
// it alone knows what to do with transparency.
std::string png_bytes(cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  if (cairo_image_surface_get_format(surface) != CAIRO_FORMAT_RGB24) {
    std::string with_alpha;
    require_drawn(cairo_surface_write_to_png_stream(surface, append_bytes, &with_alpha));
    return with_alpha;
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(cairo_image_surface_get_width(surface));
  image.height = static_cast<png_uint_32>(cairo_image_surface_get_height(surface));
  image.format = PNG_FORMAT_RGB;
  image.flags = PNG_IMAGE_FLAG_FAST;
  const std::vector<png_byte> rows = rgb_rows(surface, image.width, image.height);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, rows.data(), 0, nullptr))
    throw Error(std::string("cannot write the picture: ") + image.message);
  bytes.resize(size);
  return bytes;
}

}  // namespace isostretch::figures
