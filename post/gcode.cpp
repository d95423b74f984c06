// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/gcode.h"

#include <fmt/format.h>

#include <cstdlib>

namespace dgt {
namespace {

/// A unit as a whole number of steps of its last decimal.
struct DecimalUnit {
  std::int64_t steps = 1;
  int decimals = 0;
};

DecimalUnit decimal_unit(const Rational& unit) {
  DecimalUnit result;
  Rational scaled = unit;
  constexpr int kMostDecimals = 9;
  while (scaled.get_den() != 1 && result.decimals < kMostDecimals) {
    scaled *= 10;
    ++result.decimals;
  }
  // Settings take no unit beyond these limits; within them k·steps fits 64 bits.
  DGT_CHECK(scaled.get_den() == 1 && scaled.get_num() <= 1'000'000);
  result.steps = scaled.get_num().get_si();
  return result;
}

class Printer {
 public:
  Printer(const Plan& plan, const Toolpath& path, const Dialect& dialect)
      : plan_(plan),
        path_(path),
        dialect_(dialect),
        unit_(decimal_unit(dialect.unit)),
        absolute_(dialect.positions == Positions::Absolute) {}

  std::string run() {
    for (const std::string& line : dialect_.header) append_line(line);
    for (const Block& block : plan_.blocks) {
      append_block(block);
      append_line("");
    }
    for (const std::string& line : dialect_.footer) append_line(line);
    return fmt::to_string(out_);
  }

 private:
  void append(std::string_view text) { out_.append(text.data(), text.data() + text.size()); }
  void append_line(std::string_view line) {
    append(line);
    append(dialect_.line_end);
  }

  void append_block(const Block& block) {
    switch (block.kind) {
      case BlockKind::Rapid:
        append("G00");
        return append_end(block);
      case BlockKind::Line:
        append("G01");
        append_end(block);
        return append_feed(block);
      case BlockKind::Arc:
        append(block.path.ccw ? "G03" : "G02");
        append_end(block);
        append_word(" I", block.path.centre.x - block.path.from.x, absolute_);
        append_word(" J", block.path.centre.y - block.path.from.y, absolute_);
        return append_feed(block);
      case BlockKind::Dwell:
        return append_dwell(block);
      case BlockKind::Words:
        return append(block.words);
    }
  }

  void append_end(const Block& block) {
    const GridPoint& to = block.path.to;
    const GridPoint from = absolute_ ? GridPoint{} : block.path.from;
    append_word(" X", to.x - from.x, absolute_);
    append_word(" Y", to.y - from.y, absolute_);
    if (!block.has_height) return;
    append_word(" Z", absolute_ ? block.height : block.height - height_, true);
    height_ = block.height;
  }

  void append_word(std::string_view word, std::int64_t units, bool even_if_zero) {
    if (units == 0 && !even_if_zero) return;
    append(word);
    const std::int64_t steps = units * unit_.steps;
    if (steps < 0) out_.push_back('-');
    const fmt::format_int digits(std::llabs(steps));
    const auto decimals = static_cast<std::size_t>(unit_.decimals);
    std::string_view number(digits.data(), digits.size());
    std::string padded;
    if (number.size() <= decimals) {
      padded.assign(decimals + 1 - number.size(), '0');
      padded += number;
      number = padded;
    }
    append(number.substr(0, number.size() - decimals));
    if (decimals == 0) return;
    out_.push_back('.');
    append(number.substr(number.size() - decimals));
  }

  void append_feed(const Block& block) {
    if (!dialect_.writes_feed) return;
    const Rational* feed = feed_of(path_.moves[block.move]);
    if (feed == nullptr || feed == last_feed_) return;
    const bool changed = last_feed_ == nullptr || *feed != *last_feed_;
    last_feed_ = feed;
    if (!changed) return;
    append(" F");
    append(to_short_decimal(*feed, 3));
  }

  const Rational* feed_of(const Move& move) const {
    if (dialect_.feed) return dialect_.feed.get();
    if (move.feed) return move.feed.get();
    return dialect_.needs_feed && last_feed_ == nullptr ? &dialect_.default_feed : nullptr;
  }

  void append_dwell(const Block& block) {
    const RationalPtr& seconds = path_.moves[block.move].seconds;
    DGT_CHECK(seconds != nullptr);
    const int scale = dialect_.dwell_unit == DwellUnit::Milliseconds ? 1000 : 1;
    append(dialect_.dwell_word);
    append(to_short_decimal(Rational(*seconds * scale), 6));
  }

  const Plan& plan_;
  const Toolpath& path_;
  const Dialect& dialect_;
  const DecimalUnit unit_;
  const bool absolute_;
  std::int64_t height_ = 0;
  const Rational* last_feed_ = nullptr;
  fmt::memory_buffer out_;
};

}  // namespace

std::string gcode_text(const Plan& plan, const Toolpath& path, const Dialect& dialect) {
  return Printer(plan, path, dialect).run();
}

}  // namespace dgt
