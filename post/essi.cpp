// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/essi.h"

#include <fmt/format.h>

#include <cstdlib>
#include <iterator>

namespace dgt {
namespace {

void append_signed(fmt::memory_buffer& out, std::int64_t value) {
  out.push_back(value < 0 ? '-' : '+');
  if (value == 0) return;
  const fmt::format_int digits(std::llabs(value));
  out.append(digits.data(), digits.data() + digits.size());
}

void append_travel(fmt::memory_buffer& out, const Block& block) {
  const WrittenArc& path = block.path;
  append_signed(out, path.to.x - path.from.x);
  append_signed(out, path.to.y - path.from.y);
  if (block.kind != BlockKind::Arc) return;
  append_signed(out, path.radius);
  out.push_back(path.major ? '+' : '-');
  out.push_back(path.ccw ? '-' : '+');
}

}  // namespace

std::string essi_text(const Plan& plan, const Dialect& dialect) {
  fmt::memory_buffer out;
  const auto append_line = [&](std::string_view line) {
    out.append(line.data(), line.data() + line.size());
    out.append(dialect.line_end.data(), dialect.line_end.data() + dialect.line_end.size());
  };
  for (const std::string& line : dialect.header) append_line(line);
  for (const Block& block : plan.blocks) {
    if (block.kind != BlockKind::Words) append_travel(out, block);
    append_line(block.words);
  }
  for (const std::string& line : dialect.footer) append_line(line);
  return fmt::to_string(out);
}

}  // namespace dgt
