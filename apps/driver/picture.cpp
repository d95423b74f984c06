// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/picture.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace dgt {
namespace {

constexpr double kPointsPerPixel = 0.75;  // 72 to the inch for 96

struct Release {
  void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Handle = std::unique_ptr<RsvgHandle, Release>;
using Surface = std::unique_ptr<cairo_surface_t, Release>;
using Context = std::unique_ptr<cairo_t, Release>;

/// What went wrong, in the library's words.
class Complaint {
 public:
  Complaint() = default;
  Complaint(const Complaint&) = delete;
  Complaint& operator=(const Complaint&) = delete;
  ~Complaint() { g_clear_error(&error_); }
  GError** place() { return &error_; }
  [[noreturn]] void raise() const {
    throw std::runtime_error(error_ != nullptr ? error_->message : "the drawing failed");
  }

 private:
  GError* error_ = nullptr;
};

struct Size {
  double width = 0;
  double height = 0;
};

Handle handle_of(const std::string& svg) {
  Complaint complaint;
  Handle handle(rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(),
                                          complaint.place()));
  if (!handle) complaint.raise();
  return handle;
}

Size size_of(RsvgHandle* handle) {
  Size size;
  if (!rsvg_handle_get_intrinsic_size_in_pixels(handle, &size.width, &size.height))
    throw std::runtime_error("the drawing has no size");
  return size;
}

cairo_status_t append(void* out, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
}

void paint(RsvgHandle* handle, cairo_surface_t* surface, const Size& size) {
  const Context context(cairo_create(surface));
  const RsvgRectangle whole{0, 0, size.width, size.height};
  Complaint complaint;
  if (!rsvg_handle_render_document(handle, context.get(), &whole, complaint.place()))
    complaint.raise();
  check(cairo_status(context.get()));
}

}  // namespace

std::string png_of(const std::string& svg) {
  const Handle handle = handle_of(svg);
  const Size size = size_of(handle.get());
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32,
                                                   static_cast<int>(std::ceil(size.width)),
                                                   static_cast<int>(std::ceil(size.height))));
  check(cairo_surface_status(surface.get()));
  paint(handle.get(), surface.get(), size);
  std::string bytes;
  check(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
  return bytes;
}

std::string pdf_of(const std::string& svg) {
  const Handle handle = handle_of(svg);
  const Size pixels = size_of(handle.get());
  const Size points{pixels.width * kPointsPerPixel, pixels.height * kPointsPerPixel};
  std::string bytes;
  const Surface surface(
      cairo_pdf_surface_create_for_stream(append, &bytes, points.width, points.height));
  check(cairo_surface_status(surface.get()));
  // The hour at which a drawing is made is no part of it.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                 "2000-01-01T00:00:00Z");
  paint(handle.get(), surface.get(), points);
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
  return bytes;
}

}  // namespace dgt
