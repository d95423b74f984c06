// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/three_b/block.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "lang/text/look_alike.h"
#include "lang/text/reading.h"
#include "lang/text/utf8.h"

namespace dgt::three_b {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// NUL and SUB are what tapes and DOS end with.
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0' || c == 0x1A;
}
bool is_line_end(char c) { return c == '\n' || c == '\r'; }
bool is_foreign(char c) { return static_cast<unsigned char>(c) >= 0x80; }
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
bool is_letter(char c) { return (upper(c) >= 'A' && upper(c) <= 'Z') || is_foreign(c); }

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = upper(c);
  return result;
}

// The letter Н is on the key of Y; no word of 3B has the H that it looks like.
bool is_cyrillic_en(char32_t c) { return c == U'Н' || c == U'н'; }

/// A line of a title begins with a word, which no block does.
bool is_title(std::string_view line) {
  const std::string text = upper(line);
  if (text.size() < 2 || !is_letter(text[0]) || !is_letter(text[1])) return false;
  if (text.starts_with("BB") || text.starts_with("DD") || text.starts_with("END")) return false;
  return text.find("GX") == std::string::npos && text.find("GY") == std::string::npos;
}

}  // namespace

BlockReader::BlockReader(const SourceFile& file, const Rational& unit, DiagnosticBag& bag)
    : file_(file),
      unit_(unit),
      bag_(bag),
      text_(file.text().data()),
      size_(static_cast<std::uint32_t>(file.text().size())) {
  report_reading(file, bag);
}

void BlockReader::report(Message message, std::uint32_t begin, std::uint32_t end,
                         std::vector<std::string> arguments) {
  bag_.add({message, {&file_, begin, end}, std::move(arguments)});
}

bool BlockReader::next(Block& block) {
  for (;;) {
    if (!is_line_open_) {
      if (at_ >= size_) return false;
      if (begin_line(block)) return true;
      if (!is_line_open_) continue;
    }
    is_line_open_ = false;
    begin_block(block);
    if (!read_block(block)) {
      skip_line();
      continue;
    }
    content_ = at_;
    began_ = true;
    block.end = at_;
    skip_blanks();
    if (peek() == ';') {
      ++at_;
      read_place(block.place, block.has_place);
      skip_line();
    } else if (is_line_end(peek())) {
      skip_line();
    } else {
      is_line_open_ = true;
    }
    return true;
  }
}

void BlockReader::begin_block(Block& block) {
  block.line = line_;
  block.begin = block.end = at_;
  block.column = 1;
  if (at_ > line_begin_)
    block.column = count_code_points({text_ + line_begin_, at_ - line_begin_}) + 1;
  block.has_place = false;
}

/// True for a block that is a title's; opens the line when there is something to be read on it.
bool BlockReader::begin_line(Block& block) {
  ++line_;
  line_begin_ = at_;
  skip_blanks();
  const char c = peek();
  const bool is_comment = c == ';' || c == '*' || c == '%';
  if (is_line_end(c) || is_comment) {
    skip_line();
    return false;
  }
  if (!began_ && is_letter(c)) {
    std::uint32_t end = at_;
    while (end < size_ && !is_line_end(text_[end])) ++end;
    if (is_title(file_.text().substr(at_, end - at_))) {
      const bool is_start = read_title(block);
      skip_line();
      return is_start;
    }
  }
  content_ = at_;
  read_label();
  is_line_open_ = !is_line_end(peek());
  if (!is_line_open_) {
    refuse();
    skip_line();
  }
  return false;
}

/// Whether the title says where the program starts.
bool BlockReader::read_title(Block& block) {
  begin_block(block);
  std::uint32_t end = at_;
  while (end < size_ && !is_line_end(text_[end])) ++end;
  const std::string line = upper(file_.text().substr(at_, end - at_));
  const std::size_t equals = line.find('=');
  if (!line.starts_with("START") || equals == std::string::npos) return false;
  at_ += static_cast<std::uint32_t>(equals) + 1;
  read_place(block.place, block.has_place);
  block.end = at_;
  block.kind = Block::Kind::Start;
  return block.has_place;
}

/// `N 12:`, `0012`, `12.`: read over.
void BlockReader::read_label() {
  const std::uint32_t begin = at_;
  if (letter_at(at_) == 'N') {
    ++at_;
    skip_blanks();
    if (!is_digit(peek())) {
      at_ = begin;
      return;
    }
  }
  while (is_digit(peek())) ++at_;
  if (at_ == begin) return;
  skip_blanks();
  if (peek() == ':' || peek() == '.' || peek() == ')') ++at_;
  skip_blanks();
}

bool BlockReader::read_block(Block& block) {
  const std::uint32_t begin = at_;
  const char letter = read_letter();
  if (letter == 'B') return read_words(block);
  if ((letter == 'D' || letter == 'E') && read_stop(block)) return true;
  at_ = begin;
  refuse();
  return false;
}

/// Behind a D or an E.
bool BlockReader::read_stop(Block& block) {
  const std::string word = [&] {
    std::uint32_t end = at_;
    while (end < size_ && is_letter(text_[end])) ++end;
    return upper(file_.text().substr(at_, end - at_));
  }();
  const bool is_d = upper(text_[block.begin]) == 'D';
  if (is_d && word.empty()) {
    block.kind = Block::Kind::Pause;
    return true;
  }
  if (word != (is_d ? "D" : "") && (is_d || word != "ND")) return false;
  at_ += static_cast<std::uint32_t>(word.size());
  block.kind = Block::Kind::End;
  return true;
}

/// Behind the first B.
bool BlockReader::read_words(Block& block) {
  for (std::int64_t* const value : {&block.x, &block.y, &block.count}) {
    if (value != &block.x) {
      skip_blanks();
      const std::uint32_t begin = at_;
      if (read_letter() != 'B') return at_ = begin, refuse(), false;
    }
    skip_blanks();
    if (!read_number(*value)) return false;
    skip_blanks();
  }
  return read_axis(block) && read_way(block);
}

/// An empty number is 0.
bool BlockReader::read_number(std::int64_t& value) {
  const std::uint32_t begin = at_;
  while (peek() == '0') ++at_;
  const std::uint32_t first = at_;
  std::uint64_t digits = 0;
  for (; is_digit(peek()); ++at_)
    digits = 10 * digits + static_cast<std::uint64_t>(peek() - '0');  // may wrap: reported below
  value = static_cast<std::int64_t>(digits);
  const char next = peek();
  const bool is_signed = at_ == begin && (next == '-' || next == '+');
  const bool has_fraction =
      (next == '.' || next == ',') && at_ + 1 < size_ && is_digit(text_[at_ + 1]);
  if (is_signed || has_fraction) {
    for (++at_; is_digit(peek()) || peek() == '.';) ++at_;
    report(Message::ThreeBNumber, begin, at_,
           {std::string(file_.text().substr(begin, at_ - begin)), to_short_decimal(unit_)});
    return false;
  }
  if (at_ - first <= kMaxWordDigits) return true;
  report(Message::NumberTooLong, begin, at_,
         {std::to_string(at_ - first), std::to_string(kMaxWordDigits)});
  return false;
}

bool BlockReader::read_axis(Block& block) {
  const std::uint32_t begin = at_;
  const char letter = read_letter();
  if (letter == 'B') {
    report(Message::ThreeBIs4B, begin, at_, {});
    return false;
  }
  if (letter == 'G') {
    skip_blanks();
    block.axis_begin = at_;
    const char axis = read_letter();
    block.axis_end = at_;
    if (axis == 'X' || axis == 'Y') {
      block.axis = axis == 'X' ? Axis::X : Axis::Y;
      return true;
    }
    at_ = block.axis_begin;
  } else {
    at_ = begin;
  }
  refuse();
  return false;
}

bool BlockReader::read_way(Block& block) {
  skip_blanks();
  block.way_begin = at_;
  const char kind = read_letter();
  block.kind = kind == 'L' ? Block::Kind::Line : Block::Kind::Arc;
  block.counter_clockwise = kind == 'N';
  bool is_known = kind == 'L';
  if (kind == 'S' || kind == 'N') {
    skip_blanks();
    is_known = read_letter() == 'R';
  }
  if (is_known) {
    skip_blanks();
    const char digit = peek();
    const bool is_short = at_ + 1 >= size_ || !is_digit(text_[at_ + 1]);
    if (digit >= '1' && digit <= '4' && is_short) {
      ++at_;
      block.quadrant = digit - '0';
      return true;
    }
  }
  at_ = block.way_begin;
  refuse();
  return false;
}

/// `X , Y` in mm, if that is what stands here.
void BlockReader::read_place(NotedPlace& place, bool& has_place) {
  has_place = false;
  skip_blanks();
  if (!read_decimal(place.x)) return;
  skip_blanks();
  if (peek() == ',') ++at_;
  skip_blanks();
  has_place = read_decimal(place.y);
}

bool BlockReader::read_decimal(Decimal& number) {
  number = {};
  number.begin = at_;
  const bool is_negative = peek() == '-';
  if (peek() == '-' || peek() == '+') ++at_;
  std::size_t digits = 0;
  bool has_point = false;
  for (; is_digit(peek()) || (peek() == '.' && !has_point); ++at_) {
    if (peek() == '.') {
      has_point = true;
      continue;
    }
    if (++digits > kMaxWordDigits) return false;
    number.mantissa = 10 * number.mantissa + (peek() - '0');
    if (has_point) ++number.decimals;
  }
  if (is_negative) number.mantissa = -number.mantissa;
  number.end = at_;
  return digits > 0;
}

/// The Latin capital that stands here or is meant, read; NUL when there is none.
char BlockReader::read_letter() {
  const char c = upper(peek());
  if (c >= 'A' && c <= 'Z') {
    ++at_;
    return c;
  }
  if (!is_foreign(c)) return '\0';
  const CodePoint point = code_point_at(file_.text(), at_);
  const Range range{&file_, at_, at_ + point.size};
  const bool is_en = is_cyrillic_en(point.value);
  const char latin = is_en ? '\0' : latin_look_alike(point.value);
  const char key = is_en ? 'Y' : latin_on_key(point.value);
  if (latin == '\0' && key == '\0') return '\0';
  const std::string replacement(1, latin != '\0' ? latin : key);
  at_ += point.size;
  bag_.add({latin != '\0' ? Message::LookAlike : Message::WrongLayout,
            range,
            {std::string(range.text()), replacement},
            {},
            FixIt{range, replacement, latin != '\0' ? Certainty::Sure : Certainty::Guess}});
  return replacement[0];
}

char BlockReader::letter_at(std::uint32_t at) const { return at < size_ ? upper(text_[at]) : '\0'; }

/// From here on the line is no block any more.
void BlockReader::refuse() {
  const std::uint32_t begin = at_;
  std::uint32_t end = content_;
  for (at_ = end; at_ < size_ && !is_line_end(text_[at_]) && text_[at_] != ';'; ++at_)
    if (!is_blank(text_[at_])) end = at_ + 1;
  report(Message::ThreeBNoBlock, std::min(begin, end), end,
         {std::string(file_.text().substr(content_, end - content_))});
}

void BlockReader::skip_blanks() {
  while (at_ < size_) {
    if (text_[at_] > ' ' && !is_foreign(text_[at_])) return;
    if (is_blank(text_[at_])) {
      ++at_;
    } else if (is_foreign(text_[at_])) {
      const CodePoint c = code_point_at(file_.text(), at_);
      if (!is_wide_blank(c.value)) return;
      at_ += c.size;
    } else {
      return;
    }
  }
}

/// To the beginning of the next line.
void BlockReader::skip_line() {
  while (at_ < size_ && !is_line_end(text_[at_])) ++at_;
  if (at_ == size_) return;
  const bool is_pair = text_[at_] == '\r' && at_ + 1 < size_ && text_[at_ + 1] == '\n';
  at_ += is_pair ? 2 : 1;
}

}  // namespace dgt::three_b
