// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "device/tape.h"

/// A tape in letters, one row a line, seen from above as it lies in the reader: tracks 8 to 4, the
/// feed hole, tracks 3 to 1, then what the row says.
///
///     ___________
///     |o o  .o o|  %
///     |o   o.o o|  CR
///     ~~~~~~~~~~~  gap: the reader fell silent
///     ___________
namespace dgt {

/// Rows `first` to `last` (from 0, `last` not included) and the gaps among them.
struct RowRange {
  std::size_t first = 0;
  std::size_t last = static_cast<std::size_t>(-1);
};
[[nodiscard]] std::string to_picture(const Tape& tape, RowRange rows = {});

/// Whether bytes look like a picture rather than like rows: they begin with its upper edge.
[[nodiscard]] bool is_picture(std::string_view bytes);

/// A line that is no part of a picture.
struct PictureFault {
  std::size_t begin = 0;  ///< bytes of the picture, without the line end
  std::size_t end = 0;
};
/// Reads a picture: lines `|…|` as rows, `~` as gaps; edges, empty lines, lines that begin with `#`
/// and whatever stands behind a row mean nothing. Any letter `o`, `O` or `*` is a hole.
///  (1) from_picture(to_picture(tape)) is the tape.
[[nodiscard]] tl::expected<Tape, PictureFault> from_picture(std::string_view picture);

}  // namespace dgt
