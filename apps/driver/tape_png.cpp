// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/tape_png.h"

#include <cairo.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "kernel/check.h"

namespace dgt {
namespace {

constexpr double kMostPixels = 32767;

struct Colour {
  double red, green, blue;
};
constexpr Colour kGround{1, 1, 1};
constexpr Colour kPaper{0.91, 0.87, 0.75};
constexpr Colour kHole{0.1, 0.1, 0.1};

void use(cairo_t* cairo, const Colour& colour) {
  cairo_set_source_rgb(cairo, colour.red, colour.green, colour.blue);
}

void paint_holes(cairo_t* cairo, const std::vector<DrawnHole>& holes, double diameter) {
  for (const DrawnHole& hole : holes) {
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, hole.x, hole.y, diameter / 2, 0, 2 * std::numbers::pi);
  }
  cairo_fill(cairo);
}

void paint(cairo_t* cairo, const TapeDrawing& drawing) {
  use(cairo, kGround);
  cairo_paint(cairo);
  for (const DrawnStrip& strip : drawing.strips) {
    use(cairo, kPaper);
    cairo_rectangle(cairo, strip.x, strip.y, strip.length, kTapeWidth);
    cairo_fill(cairo);
    use(cairo, kHole);
    paint_holes(cairo, strip.feed, kFeedHole);
    paint_holes(cairo, strip.code, kCodeHole);
  }
}

cairo_status_t append(void* png, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(png)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::optional<std::string> to_png(const TapeDrawing& drawing, double pixels_per_mm) {
  const double width = std::ceil(drawing.width * pixels_per_mm);
  const double height = std::ceil(drawing.height * pixels_per_mm);
  if (width > kMostPixels || height > kMostPixels) return std::nullopt;
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width),
                                 static_cast<int>(height)),
      cairo_surface_destroy);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(surface.get()),
                                                                 cairo_destroy);
  cairo_scale(cairo.get(), pixels_per_mm, pixels_per_mm);
  paint(cairo.get(), drawing);
  std::string png;
  const cairo_status_t written = cairo_surface_write_to_png_stream(surface.get(), append, &png);
  DGT_CHECK(written == CAIRO_STATUS_SUCCESS);
  return png;
}

}  // namespace dgt
