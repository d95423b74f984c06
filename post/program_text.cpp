// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/program_text.h"

#include <cstdlib>

namespace dgt {

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

void append_millimetres(fmt::memory_buffer& out, std::int64_t units, const DecimalUnit& unit,
                        const Spelling& spelling) {
  if (units < 0 || spelling.plus) out.push_back(units < 0 ? '-' : '+');
  if (!spelling.point) {
    const fmt::format_int counted(std::llabs(units));
    return out.append(counted.data(), counted.data() + counted.size());
  }
  const fmt::format_int digits(std::llabs(units * unit.steps));
  const auto decimals = static_cast<std::size_t>(unit.decimals);
  std::string_view number(digits.data(), digits.size());
  std::string padded;
  if (number.size() <= decimals) {
    padded.assign(decimals + 1 - number.size(), '0');
    padded += number;
    number = padded;
  }
  const std::size_t point = number.size() - decimals;
  out.append(number.data(), number.data() + point);
  std::string_view fraction = number.substr(point);
  if (!spelling.trailing_zeros) fraction = fraction.substr(0, fraction.find_last_not_of('0') + 1);
  // A number without a point counts units on many a control.
  if (decimals == 0 && spelling.trailing_zeros) return;
  out.push_back('.');
  out.append(fraction.data(), fraction.data() + fraction.size());
}

std::int64_t largest_units(const Dialect& dialect) {
  if (!dialect.largest) return kMaxUnits;
  const Rational units = *dialect.largest / dialect.unit;
  const Integer whole = units.get_num() / units.get_den();
  return whole > kMaxUnits ? kMaxUnits : static_cast<std::int64_t>(whole.get_si());
}

namespace {

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

}  // namespace

ProgramText::ProgramText(const Plan& plan, const Dialect& dialect, std::vector<WriteFault>& faults)
    : plan_(plan),
      dialect_(dialect),
      faults_(faults),
      largest_(largest_units(dialect)),
      next_number_(dialect.line_numbers.first) {
  for (const std::string& line : dialect.header) add_line(line);
}

void ProgramText::add_line(const std::string& line) {
  std::string filled = line;
  const DecimalUnit unit = decimal_unit(dialect_.unit);
  const auto fill = [&](std::string_view what, std::int64_t units) {
    if (filled.find(what) == std::string::npos) return;
    fmt::memory_buffer number;
    append_millimetres(number, units, unit, dialect_.spelling);
    replace_all(filled, what, {number.data(), number.size()});
  };
  fill("{x}", plan_.start.x);
  fill("{y}", plan_.start.y);
  append(filled);
}

void ProgramText::append(std::string_view line) {
  const LineNumbers& numbers = dialect_.line_numbers;
  const bool is_numbered = !numbers.word.empty() && !line.empty() &&
                           std::string_view("%O:(").find(line.front()) == std::string_view::npos;
  if (is_numbered) {
    fmt::format_to(fmt::appender(out_), "{}{}{}", numbers.word, next_number_,
                   dialect_.spelling.separator);
    next_number_ += numbers.step;
  }
  out_.append(line.data(), line.data() + line.size());
  out_.append(dialect_.line_end.data(), dialect_.line_end.data() + dialect_.line_end.size());
}

void ProgramText::add(std::string_view line, std::size_t move) {
  const std::size_t begin = out_.size();
  append(line);
  const std::size_t length = out_.size() - begin - dialect_.line_end.size();
  if (dialect_.longest_line > 0 && length > dialect_.longest_line)
    fault(WriteFault::Kind::LineTooLong, move);
}

void ProgramText::check_size(std::int64_t units, std::size_t move) {
  if (units > largest_ || units < -largest_) fault(WriteFault::Kind::BeyondLargest, move);
}

/// Told once for a move, whatever its blocks.
void ProgramText::fault(WriteFault::Kind kind, std::size_t move) {
  if (!faults_.empty() && faults_.back().kind == kind && faults_.back().move == move) return;
  WriteFault& fault = faults_.emplace_back();
  fault.kind = kind;
  fault.move = move;
}

std::string ProgramText::finish() {
  for (const std::string& line : dialect_.footer) add_line(line);
  return fmt::to_string(out_);
}

std::string FeedWords::next(const Move& move) {
  if (!dialect_.writes_feed) return {};
  const Rational* const feed = feed_of(move);
  if (feed == nullptr || feed == last_) return {};
  const bool changed = last_ == nullptr || *feed != *last_;
  last_ = feed;
  return changed ? to_short_decimal(*feed, dialect_.feed_decimals) : std::string();
}

const Rational* FeedWords::feed_of(const Move& move) const {
  if (dialect_.feed) return dialect_.feed.get();
  if (move.feed) return move.feed.get();
  return dialect_.needs_feed && last_ == nullptr ? &dialect_.default_feed : nullptr;
}

std::string dwell_number(const Move& move, const Dialect& dialect) {
  DGT_CHECK(move.seconds != nullptr);
  int scale = 1;
  if (dialect.dwell_unit == DwellUnit::Tenths) scale = 10;
  if (dialect.dwell_unit == DwellUnit::Milliseconds) scale = 1000;
  return to_short_decimal(Rational(*move.seconds * scale), dialect.dwell_decimals);
}

}  // namespace dgt
