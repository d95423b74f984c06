// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "apps/driver/file_io.h"
#include "device/picture.h"
#include "lang/text/diagnostic.h"

/// Tapes as files.
namespace dgt {

enum class TapeForm : std::uint8_t {
  Raw,      ///< a byte a row, `.tap`
  Picture,  ///< letters, `.txt`; read back like rows
  Svg,
  Png,
  Text  ///< the program that is on it
};

/// By the extension: `.tap`, `.txt`, `.svg`, `.png`.
[[nodiscard]] std::optional<TapeForm> tape_form_of(const std::string& name);

/// A tape file: rows, or a picture of them, as its beginning tells. Drawings (PNG, SVG) are told
/// from tapes and refused.
struct TapeImage {
  Tape tape;
  std::shared_ptr<const SourceFile> file;  ///< of a picture or a drawing
  DiagnosticBag bag;                       ///< points into `file`; with errors there is no tape
};
[[nodiscard]] TapeImage read_tape_image(const std::string& name, std::string_view bytes);

/// Whether the file holds a tape rather than a program: by its extension `.tap` or its beginning.
[[nodiscard]] bool is_tape_image(const std::string& name, std::string_view bytes);

/// A picture cannot be so large: 32767 pixels on either side.
struct PictureTooLarge {};

/// The rows in a form, but Text. A PNG has kPixelsPerMm.
[[nodiscard]] tl::expected<std::string, PictureTooLarge> in_form(const Tape& tape, TapeForm form,
                                                                 RowRange rows = {});
inline constexpr double kPixelsPerMm = 10;

}  // namespace dgt
