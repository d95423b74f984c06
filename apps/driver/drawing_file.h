// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "apps/driver/pipeline.h"
#include "post/svg.h"

/// Drawings of a program as files.
namespace dgt {

enum class DrawingForm : std::uint8_t { Svg, Pdf, Png, Dxf };

/// By the extension, in either case; standard output is SVG.
[[nodiscard]] std::optional<DrawingForm> drawing_form(const std::string& name);

struct DrawingOptions {
  DrawingForm form = DrawingForm::Svg;
  bool names = false;  ///< the elements too, with their names and directions; not in DXF
  DrawingStyle style;  ///< not of DXF
};
/// The bytes of the file. Throws std::runtime_error when a library fails. Precondition: `made` has
/// a path.
[[nodiscard]] std::string drawing_of(const Compilation& made, const DrawingOptions& options);

}  // namespace dgt
