// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "lang/text/source_file.h"

namespace dgt {

/// The byte of the text where column `column` (from 1, in characters) of line `line` begins; the
/// end of the line when it is shorter.
[[nodiscard]] std::uint32_t byte_at(const SourceFile& file, std::uint32_t line,
                                    std::uint32_t column);

}  // namespace dgt
