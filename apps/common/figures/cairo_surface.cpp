#include "common/figures/cairo_surface.hpp"

namespace isostretch::app::figures {

cairo_status_t append_bytes(void* text, const unsigned char* data, unsigned int size) {
  try {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
  } catch (...) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

std::string png_bytes(cairo_surface_t* surface) {
  std::string bytes;
  require_drawn(cairo_surface_write_to_png_stream(surface, append_bytes, &bytes));
  return bytes;
}

}  // namespace isostretch::app::figures
