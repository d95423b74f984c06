// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/source_file.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "kernel/check.h"
#include "lang/text/encoding.h"

namespace dgt {
namespace {

std::vector<std::uint32_t> find_line_starts(std::string_view text) {
  std::vector<std::uint32_t> starts{0};
  const std::size_t size = text.size();
  for (std::size_t i = 0; i < size; ++i) {
    const char c = text[i];
    if (c != '\n' && c != '\r') continue;
    if (c == '\r' && i + 1 < size && text[i + 1] == '\n') ++i;
    if (i + 1 < size) starts.push_back(static_cast<std::uint32_t>(i + 1));
  }
  return starts;
}

}  // namespace

SourceFile::SourceFile(std::string name, std::string_view bytes, std::optional<Encoding> forced)
    : name_(std::move(name)), is_utf16_(!forced && looks_like_utf16(bytes)) {
  if (is_utf16_) bytes = {};
  if (!forced) guess_ = detect_encoding(bytes);
  read_ = decode(bytes, forced ? *forced : guess_->encoding);
  DGT_CHECK(read_.text.size() < std::numeric_limits<std::uint32_t>::max());
  line_starts_ = find_line_starts(read_.text);
}

std::string_view SourceFile::line_text(std::uint32_t line) const {
  const std::size_t begin = line_starts_[line - 1];
  const std::size_t end = line < line_count() ? line_starts_[line] : read_.text.size();
  std::string_view text = read_.text;
  text = text.substr(begin, end - begin);
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

std::uint32_t SourceFile::line_at(std::uint32_t offset) const {
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  return static_cast<std::uint32_t>(after - line_starts_.begin());
}

Place Range::place() const {
  const std::uint32_t line = file->line_at(begin);
  const std::string_view text = file->line_text(line);
  const std::size_t from = std::min<std::size_t>(begin - file->line_start(line), text.size());
  const std::size_t to = std::min<std::size_t>(end - file->line_start(line), text.size());
  return {line, count_code_points(text.substr(0, from)) + 1,
          count_code_points(text.substr(from, to - from))};
}

}  // namespace dgt
