// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "lang/text/encoding.h"

namespace dgt {
namespace {

constexpr std::uint32_t kWindow = 120;  // characters of a source line shown
constexpr std::uint32_t kBefore = 40;   // of them before the caret, when the line is cut
constexpr std::string_view kEllipsis = "…";

struct Style {
  std::string_view begin;
  std::string_view end;
};

Style style(std::string_view escape, Colour colour) {
  return colour == Colour::Ansi ? Style{escape, "\x1b[0m"} : Style{"", ""};
}

// The same in both languages: scripts and editors look for these words.
std::string_view severity_word(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return "error";
    case Severity::Warning:
      return "warning";
    case Severity::Note:
      break;
  }
  return "note";
}

std::string_view severity_escape(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return "\x1b[1;31m";
    case Severity::Warning:
      return "\x1b[1;35m";
    case Severity::Note:
      break;
  }
  return "\x1b[1;36m";
}

// `count` characters of `line` from character `first` on, control characters as blanks.
std::string window_of(std::string_view line, std::uint32_t first, std::uint32_t count) {
  std::string shown;
  std::uint32_t index = 0;
  for (std::size_t i = 0; i < line.size() && index < first + count; ++index) {
    const CodePoint c = code_point_at(line, i);
    if (index >= first) {
      const bool control = (c.value < 0x20 && c.value != '\t') || c.value == 0x7F;
      shown += control ? std::string_view(" ") : line.substr(i, c.size);
    }
    i += c.size;
  }
  return shown;
}

// As many blanks as `shown` has characters, its tabs kept, so that what follows lines up with it.
std::string blanks_like(std::string_view shown) {
  std::string blanks;
  for (std::size_t i = 0; i < shown.size();) {
    const CodePoint c = code_point_at(shown, i);
    blanks += c.value == '\t' ? '\t' : ' ';
    i += c.size;
  }
  return blanks;
}

void append_source(std::string& out, const Range& range, const std::optional<FixIt>& fix_it,
                   Colour colour) {
  const Place place = range.place();
  const std::string_view line = range.file->line_text(place.line);
  const std::uint32_t length = count_code_points(line);
  const std::uint32_t at = place.column - 1;
  std::uint32_t first = 0;
  if (length > kWindow && at > kWindow - kBefore) first = at - kBefore;
  const std::string_view left = first > 0 ? kEllipsis : "";
  const std::string_view right = length > first + kWindow ? kEllipsis : "";
  const std::string before = std::string(left) + window_of(line, first, at - first);
  fmt::format_to(std::back_inserter(out), "{}{}{}\n", left, window_of(line, first, kWindow), right);

  const std::uint32_t visible = std::min(place.length, first + kWindow - at);
  const std::string tildes(visible > 1 ? visible - 1 : 0, '~');
  const Style green = style("\x1b[1;32m", colour);
  const std::string margin = blanks_like(before);
  fmt::format_to(std::back_inserter(out), "{}{}^{}{}\n", margin, green.begin, tildes, green.end);
  if (!fix_it || fix_it->replacement.empty() || fix_it->range.file != range.file) return;

  const Place fix = fix_it->range.place();
  if (fix.line != place.line || fix.column - 1 < first || fix.column - 1 >= first + kWindow) return;
  const std::string fix_margin =
      blanks_like(std::string(left) + window_of(line, first, fix.column - 1 - first));
  fmt::format_to(std::back_inserter(out), "{}{}{}{}\n", fix_margin, green.begin,
                 fix_it->replacement, green.end);
}

void append(std::string& out, Message message, const Range& range,
            std::span<const std::string> arguments, const std::optional<FixIt>& fix_it,
            const RenderOptions& options) {
  const Place place = range.place();
  const Severity severity = info(message).severity;
  const Style bold = style("\x1b[1m", options.colour);
  const Style hue = style(severity_escape(severity), options.colour);
  fmt::format_to(std::back_inserter(out), "{}{}:{}:{}:{} {}{}:{} {}{}{} [{}]\n", bold.begin,
                 range.file->name(), place.line, place.column, bold.end, hue.begin,
                 severity_word(severity), hue.end, bold.begin,
                 text(message, arguments, options.language), bold.end, info(message).code);
  append_source(out, range, fix_it, options.colour);
}

}  // namespace

std::string render(const Diagnostic& diagnostic, const RenderOptions& options) {
  std::string out;
  append(out, diagnostic.message, diagnostic.range, diagnostic.arguments, diagnostic.fix_it,
         options);
  for (const Note& note : diagnostic.notes) {
    append(out, note.message, note.range, note.arguments, std::nullopt, options);
  }
  return out;
}

std::string render(const DiagnosticBag& bag, const RenderOptions& options) {
  std::string out;
  for (const Diagnostic& diagnostic : bag.all()) out += render(diagnostic, options);
  return out;
}

}  // namespace dgt
