// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs have millions of blocks, so the usual word, a Latin letter and a short number, is read
// straight through; everything else takes read_special() and read_foreign().
#include "lang/gcode/block.h"

#include "lang/text/look_alike.h"
#include "lang/text/reading.h"
#include "lang/text/utf8.h"

namespace dgt::gcode {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

// The letter Н, on the key of Y, looks like an H, but where a coordinate is due it is a Y.
bool is_cyrillic_en(char32_t c) { return c == U'Н' || c == U'н'; }

}  // namespace

BlockReader::BlockReader(const SourceFile& file, DiagnosticBag& bag)
    : file_(file),
      bag_(bag),
      text_(file.text().data()),
      size_(static_cast<std::uint32_t>(file.text().size())) {
  report_reading(file, bag);
}

void BlockReader::report(Message message, const Range& range, std::vector<std::string> arguments) {
  bag_.add({message, range, std::move(arguments)});
}

bool BlockReader::next(Block& block) {
  while (at_ < size_) {
    ++line_;
    line_begin_ = at_;
    block.line = line_;
    block.begin = block.end = at_;
    block.column = 0;
    block.present = 0;
    block.g_count = block.m_count = 0;
    block.is_tape_mark = false;
    is_ascii_ = true;
    read_line(block);
    if (peek() == '\r' && at_ < size_) {
      ++at_;
      if (peek() == '\n' && at_ < size_) ++at_;
    } else if (at_ < size_) {
      ++at_;
    }
    if (!block.empty() || block.is_tape_mark) return true;
  }
  return false;
}

void BlockReader::read_line(Block& block) {
  while (at_ < size_) {
    const char c = text_[at_];
    const char letter = upper(c);
    if (letter >= 'A' && letter <= 'Z') {
      const std::uint32_t begin = at_++;
      read_word(block, letter, begin);
    } else if (is_blank(c)) {
      ++at_;
    } else if (is_line_end(c)) {
      return;
    } else if (!read_special(block)) {
      return;
    }
  }
}

/// False at the end of what the line says.
bool BlockReader::read_special(Block& block) {
  const std::uint32_t begin = at_;
  const char c = text_[at_];
  switch (c) {
    case '(':
      skip_comment();
      return true;
    case ';':
      skip_line();
      return false;
    case '%':
      block.is_tape_mark = block.empty();
      skip_line();
      return false;
    case '/':
      ++at_;
      if (!told_optional_) report(Message::GcodeOptionalBlock, from(begin));
      told_optional_ = true;
      return true;
    case '#':
    case '[':
    case '=':
      skip_to_blank();
      report(Message::GcodeParameter, from(begin), {std::string(from(begin).text())});
      skip_line();
      return false;
    default:
      break;
  }
  if (static_cast<unsigned char>(c) >= 0x80) {
    read_foreign(block);
    return true;
  }
  if (is_digit(c) || c == '.' || c == '-' || c == '+') {
    Decimal number;
    const bool is_number = read_number(number);
    if (!is_number && at_ == begin) ++at_;
    report(Message::StrayNumber, from(begin), {std::string(from(begin).text())});
    return true;
  }
  ++at_;
  if (c == '\0' || c == 0x1A) return true;  // what tapes and DOS end with
  report(Message::UnknownCharacter, from(begin), {std::string(1, c)});
  return true;
}

void BlockReader::read_foreign(Block& block) {
  is_ascii_ = false;
  const std::uint32_t begin = at_;
  const CodePoint c = code_point_at(file_.text(), at_);
  at_ += c.size;
  if (is_wide_blank(c.value)) return;
  const Range range = from(begin);
  const std::string seen(range.text());
  const bool is_en = is_cyrillic_en(c.value);
  const char key = is_en ? 'Y' : latin_on_key(c.value);
  if (const char latin = is_en ? '\0' : latin_look_alike(c.value)) {
    const std::string replacement(1, latin);
    bag_.add({Message::LookAlike, range, {seen, replacement}, {}, FixIt{range, replacement}});
    read_word(block, latin, begin);
  } else if (key != '\0') {
    const std::string replacement(1, key);
    bag_.add({Message::WrongLayout,
              range,
              {seen, replacement},
              {},
              FixIt{range, replacement, Certainty::Guess}});
    read_word(block, key, begin);
  } else {
    report(Message::UnknownCharacter, range, {seen});
  }
}

void BlockReader::note_begin(Block& block, std::uint32_t begin) {
  if (block.column != 0) return;
  block.begin = begin;
  block.column = is_ascii_ ? begin - line_begin_ + 1
                           : count_code_points({text_ + line_begin_, begin - line_begin_}) + 1;
}

void BlockReader::read_word(Block& block, char letter, std::uint32_t begin) {
  while (is_blank(peek())) ++at_;
  const char next = peek();
  if (letter == 'O' || next == '#' || next == '[' || next == '<') {
    skip_to_blank();
    const std::string seen(from(begin).text());
    if (letter != 'O') {
      report(Message::GcodeParameter, from(begin), {seen});
    } else if (block.empty() && seen.find_first_not_of("0123456789", 1) == std::string::npos &&
               seen.size() > 1) {
      while (is_blank(peek())) ++at_;
      if (at_ >= size_ || is_line_end(peek()) || peek() == '(' || peek() == ';') return;
      report(Message::GcodeProgramFlow, from(begin), {seen});
    } else {
      report(Message::GcodeProgramFlow, from(begin), {seen});
    }
    skip_line();
    return;
  }
  Decimal number;
  if (!read_number(number)) {
    report(Message::MissingNumber, from(begin), {std::string(1, letter)});
    return;
  }
  if (letter == 'N') return;
  note_begin(block, begin);
  block.end = at_;
  if (letter == 'G' || letter == 'M') return keep_code(block, letter, number, begin);
  const auto index = static_cast<std::size_t>(letter - 'A');
  if (block.has(letter)) {
    report(Message::GcodeWordTwice, from(begin), {std::string(1, letter)});
    return;
  }
  block.present |= 1U << index;
  block.words[index] = number;
  block.letters[index] = begin;
}

/// False when there is no digit.
bool BlockReader::read_number(Decimal& number) {
  number.begin = at_;
  number.is_negated = false;
  bool negative = false;
  if (peek() == '-' || peek() == '+') {
    negative = peek() == '-';
    ++at_;
  } else if (static_cast<unsigned char>(peek()) >= 0x80) {
    const CodePoint c = code_point_at(file_.text(), at_);
    if (is_typographic_minus(c.value)) {
      is_ascii_ = false;
      at_ += c.size;
      const Range range = from(number.begin);
      bag_.add({Message::TypographicSign,
                range,
                {std::string(range.text()), "-"},
                {},
                FixIt{range, "-"}});
      negative = number.is_negated = true;
      number.begin = at_;
    }
  }
  const std::uint32_t digits_begin = at_;
  std::uint64_t mantissa = 0;
  std::uint32_t point = 0;  // offset behind it
  std::uint32_t points = 0;
  for (char c = peek(); is_digit(c) || c == '.'; c = peek()) {
    ++at_;
    if (c == '.') {
      if (points++ == 0) point = at_;
    } else {
      mantissa = 10 * mantissa + static_cast<std::uint64_t>(c - '0');  // may wrap: is_long then
    }
  }
  number.end = at_;
  const std::uint32_t digits = at_ - digits_begin - points;
  if (digits == 0) return false;
  if (points > 1) {
    report(Message::TwoPoints, from(number.begin), {std::string(from(number.begin).text())});
    number.mantissa = 0;
    return true;
  }
  if (peek() == ',' && at_ + 1 < size_ && is_digit(text_[at_ + 1])) {
    ++at_;
    while (is_digit(peek())) ++at_;
    const Range range = from(number.begin);
    std::string meant(range.text());
    meant[meant.find(',')] = '.';
    bag_.add(
        {Message::GcodeDecimalComma, range, {meant}, {}, FixIt{range, meant, Certainty::Guess}});
  }
  if (digits > kMaxNcDigits) {
    report(Message::NumberTooLong, from(number.begin),
           {std::to_string(digits), std::to_string(kMaxNcDigits)});
    number.mantissa = 0;
    return true;
  }
  number.decimals = points == 0 ? 0 : number.end - point;
  number.is_long = digits > kMaxWordDigits;
  number.mantissa = number.is_long ? 0 : static_cast<std::int64_t>(mantissa);
  if (negative) number.mantissa = -number.mantissa;
  return true;
}

void BlockReader::keep_code(Block& block, char letter, const Decimal& number, std::uint32_t begin) {
  const Range range{&file_, begin, number.end};
  auto& count = letter == 'G' ? block.g_count : block.m_count;
  int value = -1;
  if (letter == 'G' && number.decimals == 1 && number.mantissa < 10'000) {
    value = static_cast<int>(number.mantissa);
  } else if (const auto whole = number.whole(); whole && *whole < 1000) {
    value = static_cast<int>(letter == 'G' ? 10 * *whole : *whole);
  }
  if (value < 0 || count == Block::kMaxCodes) {
    report(Message::GcodeBadNumber, range,
           {std::string(file_.text().substr(number.begin, number.end - number.begin)),
            std::string(1, letter)});
    return;
  }
  (letter == 'G' ? block.g : block.m)[count++] = {value, begin, number.end};
}

void BlockReader::skip_comment() {
  const std::uint32_t begin = at_;
  while (at_ < size_ && !is_line_end(text_[at_])) {
    if (static_cast<unsigned char>(text_[at_]) >= 0x80) is_ascii_ = false;
    if (text_[at_++] == ')') return;
  }
  report(Message::GcodeOpenComment, {&file_, begin, begin + 1});
}

void BlockReader::skip_to_blank() {
  while (at_ < size_ && !is_blank(text_[at_]) && !is_line_end(text_[at_])) ++at_;
}

void BlockReader::skip_line() {
  while (at_ < size_ && !is_line_end(text_[at_])) ++at_;
}

}  // namespace dgt::gcode
