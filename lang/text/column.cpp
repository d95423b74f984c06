// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/column.h"

#include "lang/text/encoding.h"

namespace dgt {

std::uint32_t byte_at(const SourceFile& file, std::uint32_t line, std::uint32_t column) {
  const std::string_view text = file.line_text(line);
  std::uint32_t offset = 0;
  for (; column > 1 && offset < text.size(); --column) offset += code_point_at(text, offset).size;
  return file.line_start(line) + offset;
}

}  // namespace dgt
