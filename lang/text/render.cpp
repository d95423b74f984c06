// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "lang/text/encoding.h"

namespace dgt {
namespace {

constexpr std::uint32_t kWindow = 120;  // characters of a source line shown
constexpr std::uint32_t kBefore = 40;   // of them before the caret, when the line is cut
constexpr std::uint32_t kTabStop = 8;
constexpr std::string_view kEllipsis = "…";
constexpr std::string_view kForInvisible = "\uFFFD";

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

// A part of a source line as it is shown: tabs as blanks, what nobody can see as a sign that one
// can, `…` where the line was cut.
class Window {
 public:
  // The part around character `at` (from 0) of `line`; all of a line that fits.
  Window(std::string_view line, std::uint32_t at) {
    const bool fits = line.size() <= kWindow || count_code_points(line) <= kWindow;
    first_ = !fits && at > kWindow - kBefore ? at - kBefore : 0;
    const std::string_view shown = without_first(line, first_);
    if (first_ > 0) append(kEllipsis, 1);
    std::size_t i = 0;
    for (std::uint32_t count = 0; i < shown.size() && count < kWindow; ++count) {
      const CodePoint c = code_point_at(shown, i);
      columns_.push_back(width_);
      append_character(c.value, shown.substr(i, c.size));
      i += c.size;
    }
    columns_.push_back(width_);
    if (i < shown.size()) append(kEllipsis, 1);
  }

  [[nodiscard]] const std::string& text() const { return text_; }
  // True when character `at` of the line, or the end behind the last one, can be pointed at.
  [[nodiscard]] bool shows(std::uint32_t at) const {
    return at >= first_ && at - first_ < columns_.size();
  }
  // Where character `at` is shown, in columns of the terminal from 0. Past the window: its end.
  [[nodiscard]] std::uint32_t column_of(std::uint32_t at) const {
    return columns_[std::min<std::size_t>(at - first_, columns_.size() - 1)];
  }

 private:
  static std::string_view without_first(std::string_view line, std::uint32_t count) {
    std::size_t i = 0;
    for (; count > 0; --count) i += code_point_at(line, i).size;
    return line.substr(i);
  }

  void append(std::string_view text, std::uint32_t width) {
    text_ += text;
    width_ += width;
  }

  void append_character(char32_t value, std::string_view bytes) {
    if (value == '\t') {
      const std::uint32_t blanks = kTabStop - width_ % kTabStop;
      append(std::string(blanks, ' '), blanks);
    } else if (is_invisible(value)) {
      append(kForInvisible, 1);
    } else {
      append(bytes, display_width(value));
    }
  }

  std::string text_;
  std::uint32_t first_ = 0;             // character of the line shown
  std::uint32_t width_ = 0;             // of `text_`, in columns
  std::vector<std::uint32_t> columns_;  // of the characters shown, then of the end
};

// `^~~~` under the range, `~~` under the other place when it is in the line and in view.
std::string marks_below(const Window& window, const Diagnostic& d) {
  const Place place = d.range.place();
  const std::uint32_t begin = window.column_of(place.column - 1);
  const std::uint32_t end = std::max(window.column_of(place.column - 1 + place.length), begin + 1);
  std::string marks(begin, ' ');
  marks.append("^").append(end - begin - 1, '~');
  if (!d.other || d.other->file != d.range.file) return marks;
  const Place other = d.other->place();
  if (other.line != place.line || !window.shows(other.column - 1)) return marks;
  const std::uint32_t from = window.column_of(other.column - 1);
  const std::uint32_t to = std::max(window.column_of(other.column - 1 + other.length), from + 1);
  if (marks.size() < to) marks.resize(to, ' ');
  for (std::uint32_t i = from; i < to; ++i) {
    if (marks[i] == ' ') marks[i] = '~';
  }
  return marks;
}

void append_source(std::string& out, const Diagnostic& d, Colour colour) {
  const Place place = d.range.place();
  const Window window(d.range.file->line_text(place.line), place.column - 1);
  const Style green = style("\x1b[1;32m", colour);
  const auto line = [&](std::size_t indent, std::string_view shown) {
    fmt::format_to(std::back_inserter(out), "{}{}{}{}\n", std::string(indent, ' '), green.begin,
                   shown, green.end);
  };
  out.append(window.text()).append("\n");
  const std::string marks = marks_below(window, d);
  const std::size_t first = marks.find_first_not_of(' ');
  line(first, std::string_view(marks).substr(first));

  const auto& fix_it = d.fix_it;
  if (!fix_it || fix_it->replacement.empty() || fix_it->range.file != d.range.file) return;
  const Place fix = fix_it->range.place();
  if (fix.line != place.line || !window.shows(fix.column - 1)) return;
  line(window.column_of(fix.column - 1), visible(fix_it->replacement));
}

void append(std::string& out, const Diagnostic& d, const RenderOptions& options) {
  const Place place = d.range.place();
  const Style bold = style("\x1b[1m", options.colour);
  const Style hue = style(severity_escape(d.severity()), options.colour);
  fmt::format_to(std::back_inserter(out), "{}{}:{}:{}:{} {}{}:{} {}{}{} [{}]\n", bold.begin,
                 visible(d.range.file->name()), place.line, place.column, bold.end, hue.begin,
                 severity_word(d.severity()), hue.end, bold.begin,
                 text(d.message, d.arguments, options.language), bold.end, d.code());
  append_source(out, d, options.colour);
}

}  // namespace

std::string render(const Diagnostic& diagnostic, const RenderOptions& options) {
  std::string out;
  append(out, diagnostic, options);
  for (const Note& note : diagnostic.notes) {
    append(out, {note.message, note.range, note.arguments}, options);
  }
  return out;
}

std::string render(const DiagnosticBag& bag, const RenderOptions& options) {
  std::string out;
  for (const Diagnostic& diagnostic : bag.all()) out += render(diagnostic, options);
  return out;
}

}  // namespace dgt
