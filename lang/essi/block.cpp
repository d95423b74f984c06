// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/essi/block.h"

#include "lang/nc/decimal.h"
#include "lang/text/look_alike.h"
#include "lang/text/reading.h"
#include "lang/text/utf8.h"

namespace dgt::essi {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

}  // namespace

BlockReader::BlockReader(const SourceFile& file, DiagnosticBag& bag)
    : file_(file),
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
  while (at_ < size_) {
    ++line_;
    const std::uint32_t line_begin = at_;
    skip_blanks();
    block.line = line_;
    block.begin = at_;
    block.column = at_ - line_begin + 1;
    block.has_number = false;
    block.count = 0;
    const bool is_block = !is_line_end(peek()) && peek() != '%' && read_line(block);
    skip_line();
    if (is_block) return true;
  }
  return false;
}

/// False for a line without a block, and with a message for one with a fault.
bool BlockReader::read_line(Block& block) {
  if (is_digit(peek())) {
    block.has_number = true;
    if (!read_digits(block.number)) return false;
  }
  block.end = at_;
  for (skip_blanks(); !is_line_end(peek()); skip_blanks()) {
    const std::uint32_t begin = at_;
    Field field;
    field.begin = begin;
    if (!read_sign(field.negative)) {
      if (is_digit(peek())) {  // behind a blank: a sign was forgotten, or two blocks share the line
        while (!is_line_end(peek())) ++at_;
        report(Message::EssiNoBlock, block.begin, at_,
               {std::string(file_.text().substr(block.begin, at_ - block.begin))});
        return false;
      }
      const CodePoint c = code_point_at(file_.text(), at_);
      report(Message::UnknownCharacter, begin, begin + c.size,
             {std::string(file_.text().substr(begin, c.size))});
      return false;
    }
    field.end = at_;
    skip_blanks();
    if (is_digit(peek())) {
      field.has_digits = true;
      if (!read_digits(field.value)) return false;
      if (field.negative) field.value = -field.value;
      field.end = at_;
    }
    block.end = field.end;
    if (block.count < Block::kMaxFields) block.fields[block.count] = field;
    ++block.count;
  }
  return true;
}

bool BlockReader::read_sign(bool& negative) {
  if (peek() == '+' || peek() == '-') {
    negative = peek() == '-';
    ++at_;
    return true;
  }
  const CodePoint c = code_point_at(file_.text(), at_);
  if (!is_typographic_minus(c.value)) return false;
  const Range range{&file_, at_, at_ + c.size};
  bag_.add(
      {Message::TypographicSign, range, {std::string(range.text()), "-"}, {}, FixIt{range, "-"}});
  at_ += c.size;
  negative = true;
  return true;
}

bool BlockReader::read_digits(std::int64_t& value) {
  const std::uint32_t begin = at_;
  std::uint64_t digits = 0;
  for (; is_digit(peek()); ++at_)
    digits = 10 * digits + static_cast<std::uint64_t>(peek() - '0');  // may wrap: reported below
  value = static_cast<std::int64_t>(digits);
  if (at_ - begin <= kMaxWordDigits) return true;
  report(Message::NumberTooLong, begin, at_,
         {std::to_string(at_ - begin), std::to_string(kMaxWordDigits)});
  return false;
}

void BlockReader::skip_blanks() {
  while (at_ < size_) {
    if (is_blank(text_[at_])) {
      ++at_;
    } else if (static_cast<unsigned char>(text_[at_]) >= 0x80) {
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

}  // namespace dgt::essi
