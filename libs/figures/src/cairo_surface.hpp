#pragma once

#include <isostretch/core/error.hpp>

#include <cairo-svg.h>
#include <cairo.h>

#include <memory>
#include <string>

// What files that draw with cairo share.
namespace isostretch::figures {

struct ReleaseCairo {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using CairoSurface = std::unique_ptr<cairo_surface_t, ReleaseCairo>;
using CairoContext = std::unique_ptr<cairo_t, ReleaseCairo>;

// Throws Error unless all is well.
inline void require_drawn(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(std::string("cannot draw the picture: ") + cairo_status_to_string(status));
}

// For what cairo writes as a stream: appends to the std::string `text`.
cairo_status_t append_bytes(void* text, const unsigned char* data, unsigned int size);

// As the bytes of a PNG file.
std::string png_bytes(cairo_surface_t* surface);

}  // namespace isostretch::figures
