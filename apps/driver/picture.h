// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

/// Drawings as PNG and PDF: the SVG of post/svg.h, painted by librsvg and cairo, so that all three
/// show the same.
namespace dgt {

/// A picture of whole pixels, as many as the SVG says. Throws std::runtime_error when the library
/// fails.
[[nodiscard]] std::string png_of(const std::string& svg);
/// One page of the size of the SVG, a pixel 1/96 inch; lines and curves stay such. The same SVG
/// gives the same bytes. Throws as above.
[[nodiscard]] std::string pdf_of(const std::string& svg);

}  // namespace dgt
