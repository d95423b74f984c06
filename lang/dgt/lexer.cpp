// SPDX-License-Identifier: GPL-3.0-or-later
//
// A word is mostly one letter and a number, so the lexer looks at the first character of each and
// knows what to read. Everything outside ASCII takes the slow path in look(): blanks that editors
// smuggle in, Cyrillic look-alikes, the typographic minus.
#include "lang/dgt/lexer.h"

#include <array>
#include <functional>
#include <set>

#include "lang/text/look_alike.h"
#include "lang/text/reading.h"
#include "lang/text/utf8.h"

namespace dgt::language {
namespace {

constexpr std::string_view kLetters = "ABCDFGIKLMNOPRSTUVWXYZ";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_language_letter(char c) { return kLetters.find(c) != std::string_view::npos; }
bool may_begin_keyword(char c) { return c == 'F' || c == 'N' || c == 'M' || c == 'O'; }
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

}  // namespace

// A character as the language reads it.
struct Lexer::Character {
  char latin = 0;  // upper-case letter or other ASCII, 0 for what the language does not know
  std::uint32_t size = 0;
  bool foreign = false;  // written otherwise than it is read
};

Lexer::Lexer(const SourceFile& file, DiagnosticBag& bag)
    : file_(file), text_(file.text()), bag_(bag) {
  report_reading(file, bag);
}

bool Lexer::next_line(Line& line) {
  if (line_number_ == file_.line_count()) return false;
  ++line_number_;
  line_ = &line;
  line.words.clear();
  line.broken = false;
  at_ = file_.line_start(line_number_);
  end_ = at_ + static_cast<std::uint32_t>(file_.line_text(line_number_).size());
  line.range = {&file_, at_, end_};
  counted_to_ = at_;
  counted_columns_ = 1;
  in_quotes_ = false;
  for (at_ = skip_blanks(at_); at_ < end_; at_ = skip_blanks(at_)) read_word();
  if (in_quotes_) close_open_quote();
  report_look_alikes(Message::LookAlike, letters_);
  report_look_alikes(Message::TypographicSign, signs_);
  return true;
}

Lexer::Character Lexer::look(std::uint32_t at) const {
  if (at >= end_) return {};
  const char c = text_[at];
  if (static_cast<unsigned char>(c) < 0x80) return {upper(c), 1, false};
  const CodePoint wide = code_point_at(text_, at);
  if (is_wide_blank(wide.value)) return {' ', wide.size, true};
  if (is_typographic_minus(wide.value)) return {'-', wide.size, true};
  if (const char sign = typewriter_sign_for(wide.value)) return {sign, wide.size, true};
  return {latin_look_alike(wide.value), wide.size, true};
}

std::uint32_t Lexer::skip_blanks(std::uint32_t at) const {
  while (at < end_) {
    const char c = text_[at];
    if (c == ' ' || c == '\t' || c == '\v' || c == '\f') {
      ++at;
    } else if (static_cast<unsigned char>(c) >= 0x80 && look(at).latin == ' ') {
      at += look(at).size;
    } else {
      break;
    }
  }
  return at;
}

std::uint32_t Lexer::column_of(std::uint32_t offset) {
  counted_columns_ += count_code_points(text_.substr(counted_to_, offset - counted_to_));
  counted_to_ = offset;
  return counted_columns_;
}

Word& Lexer::push(WordKind kind, std::uint32_t begin) {
  Word& word = line_->words.emplace_back();
  word.kind = kind;
  word.line = line_number_;
  word.column = column_of(begin);
  word.range = from(begin);
  word.number_begin = at_;
  return word;
}

void Lexer::fail(Message message, Range range, std::vector<std::string> arguments) {
  line_->broken = true;
  bag_.add({message, range, std::move(arguments)});
}

void Lexer::note_look_alike(std::uint32_t begin, std::string_view latin) {
  const bool is_letter = latin.front() >= 'A';
  (is_letter ? letters_ : signs_).push_back({from(begin), std::string(latin)});
}

// One report a line, from the first of them to the last: who types a line in the wrong layout
// types all of it so.
void Lexer::report_look_alikes(Message message, std::vector<LookAlike>& found) {
  if (found.empty()) return;
  const Range range = join(found.front().range, found.back().range);
  std::string written;
  std::string latin;
  std::string replacement;
  std::set<std::string, std::less<>> told;
  const auto list = [&](std::string& names, std::string_view name) {
    if (told.emplace(name).second) names.append(names.empty() ? "" : ", ").append(name);
  };
  std::uint32_t done = range.begin;
  for (const LookAlike& one : found) {
    replacement += text_.substr(done, one.range.begin - done);
    replacement += one.latin;
    done = one.range.end;
    list(written, one.range.text());
    list(latin, one.latin);
  }
  bag_.add({message, range, {written, latin}, {}, FixIt{range, replacement}});
  found.clear();
}

void Lexer::read_word() {
  const std::uint32_t begin = at_;
  const Character c = look(at_);
  if (c.foreign && read_unmarked_comment()) return;
  if (c.latin >= 'A' && c.latin <= 'Z') {
    if (!may_begin_keyword(c.latin) || !read_keyword()) read_letter(c);
    return;
  }
  if (is_digit(c.latin) || (c.latin == '.' && is_digit(byte(at_ + 1)))) {
    read_decimal(push(WordKind::Number, begin));
    return;
  }
  switch (c.latin) {
    case ',':
      ++at_;
      push(WordKind::Comma, begin);
      return;
    case '=':
      ++at_;
      push(WordKind::Equals, begin);
      return;
    case '+':
    case '-':
    case '*':
    case '/':
      if (read_foreign_comment()) return;
      at_ += c.size;
      if (c.foreign) note_look_alike(begin, "-");
      push(WordKind::Operator, begin).letter = c.latin;
      return;
    case '"':
      read_quote(c);
      return;
    case '\'':
      read_comment(c);
      return;
    default:
      if (read_foreign_comment() || read_brackets() || read_semicolon()) return;
      if (!read_wrong_layout()) report_unknown_characters();
  }
}

bool Lexer::read_keyword() {
  struct Keyword {
    std::string_view text;
    WordKind kind;
  };
  static constexpr std::array kKeywords = {
      Keyword{"FOR", WordKind::For}, Keyword{"NEXT", WordKind::Next}, Keyword{"MAC", WordKind::Mac},
      Keyword{"OPR", WordKind::Opr}};
  for (const Keyword& keyword : kKeywords) {
    std::uint32_t at = at_;
    bool foreign = false;
    std::size_t matched = 0;
    for (; matched < keyword.text.size(); ++matched) {
      const Character c = look(at);
      if (c.latin != keyword.text[matched]) break;
      foreign = foreign || c.foreign;
      at += c.size;
    }
    if (matched < keyword.text.size()) continue;
    const std::uint32_t begin = at_;
    at_ = at;
    if (foreign) note_look_alike(begin, keyword.text);
    push(keyword.kind, begin);
    if (keyword.kind == WordKind::Mac || keyword.kind == WordKind::Opr) read_name();
    return true;
  }
  return false;
}

// A file name ends at a blank, at a comment or with the line.
void Lexer::read_name() {
  at_ = skip_blanks(at_);
  const std::uint32_t begin = at_;
  while (at_ < end_ && text_[at_] != '\'' && skip_blanks(at_) == at_) ++at_;
  if (at_ > begin) push(WordKind::Name, begin);
}

void Lexer::read_letter(const Character& letter) {
  const std::uint32_t begin = at_;
  at_ += letter.size;
  if (!is_language_letter(letter.latin)) {
    fail(Message::UnknownLetter, from(begin), {std::string(from(begin).text())});
    at_ = skip_blanks(at_);
    Word ignored;  // its number goes with it
    read_sign_and_number(ignored);
    return;
  }
  if (letter.foreign) note_look_alike(begin, std::string_view(&letter.latin, 1));
  Word& word = push(WordKind::Letter, begin);
  word.letter = letter.latin;

  const std::uint32_t next = skip_blanks(at_);
  const char after = byte(next);
  if ((letter.latin == 'X' || letter.latin == 'Y') && (after == '>' || after == '<')) {
    at_ = next + 1;
    word.kind = WordKind::Selector;
    word.digits = (after == '>' ? 3 : 5) + (letter.latin == 'Y' ? 1 : 0);
  } else {
    read_sign_and_number(word);
  }
  word.range.end = at_;
  if (word.form != NumberForm::None) read_unit();
}

// What may follow a letter: a sign, then digits or a variable. Without a number nothing is taken,
// not even the sign.
void Lexer::read_sign_and_number(Word& word) {
  const std::uint32_t sign_at = skip_blanks(at_);
  const Character sign = look(sign_at);
  const bool has_sign = sign.latin == '-' || sign.latin == '+';
  const std::uint32_t number_at = has_sign ? skip_blanks(sign_at + sign.size) : sign_at;
  const char first = byte(number_at);
  std::uint32_t digits_at = number_at;
  NumberForm form = NumberForm::None;
  if (is_digit(first) || (first == '.' && is_digit(byte(number_at + 1)))) {
    form = NumberForm::Decimal;
  } else if (upper(first) == 'N') {
    digits_at = skip_blanks(number_at + 1);
    if (is_digit(byte(digits_at))) form = NumberForm::Variable;
  }
  word.number_begin = at_;
  if (form == NumberForm::None) return;
  if (has_sign && sign.foreign) {
    at_ = sign_at + sign.size;
    note_look_alike(sign_at, "-");
  }
  word.minus = sign.latin == '-';
  at_ = digits_at;
  read_decimal(word);
  word.form = form;
  word.number_begin = number_at;
  if (form == NumberForm::Variable && (word.scale > 0 || word.digits < 1 || word.digits > 30)) {
    fail(Message::NoSuchVariable, from(number_at), {std::string(from(number_at).text())});
    word.digits = 1;
    word.scale = 0;
  }
}

// Digits with at most one point, at least one digit; `at_` stands on the first of them.
void Lexer::read_decimal(Word& word) {
  const std::uint32_t begin = at_;
  std::uint64_t value = 0;
  std::uint32_t count = 0;
  std::uint32_t scale = 0;
  bool point = false;
  for (; at_ < end_; ++at_) {
    const char c = text_[at_];
    if (is_digit(c)) {
      value = value * 10 + static_cast<std::uint64_t>(c - '0');  // meaningless past 18 digits
      ++count;
      if (point) ++scale;
    } else if (c == '.' && !point) {
      point = true;
    } else {
      break;
    }
  }
  word.form = NumberForm::Decimal;
  word.scale = scale;
  word.digits = count <= Word::kMaxPlainDigits ? static_cast<std::int64_t>(value) : -1;
  word.number_begin = begin;
  if (byte(at_) == '.') {  // the second one
    while (is_digit(byte(at_)) || byte(at_) == '.') ++at_;
    fail(Message::TwoPoints, from(begin), {std::string(from(begin).text())});
    word.digits = 1;
    word.scale = 0;
  }
  word.range.end = at_;
  if (count > kMaxDigits) {
    fail(Message::NumberTooLong, from(begin), {std::to_string(count), std::to_string(kMaxDigits)});
    word.digits = 1;
  }
}

void Lexer::read_quote(const Character& quote) {
  const std::uint32_t begin = at_;
  at_ += quote.size;
  if (quote.foreign) note_look_alike(begin, "\"");
  push(in_quotes_ ? WordKind::QuoteClose : WordKind::QuoteOpen, begin);
  in_quotes_ = !in_quotes_;
}

void Lexer::close_open_quote() {
  Range open = line_->range;
  for (const Word& word : line_->words) {
    if (word.is(WordKind::QuoteOpen)) open = word.range;
  }
  if (!line_->broken) fail(Message::UnclosedText, open, {});
}

// Runs to the end of the line; `'@` begins a directive to the compiler.
void Lexer::read_comment(const Character& apostrophe) {
  const std::uint32_t begin = at_;
  at_ += apostrophe.size;
  if (apostrophe.foreign) note_look_alike(begin, "'");
  const std::uint32_t text = at_ + 1;
  const bool directive = byte(at_) == '@';
  at_ = end_;
  if (!directive) return;
  push(WordKind::Directive, begin).number_begin = text;
}

// Three Cyrillic letters side by side are prose: no three letters of the language stand so without
// a number, but for the keyword MAC.
bool Lexer::read_unmarked_comment() {
  std::uint32_t end = at_;
  std::uint32_t letters = 0;
  while (end < end_) {
    const CodePoint c = code_point_at(text_, end);
    if (!is_cyrillic(c.value)) break;
    end += c.size;
    ++letters;
  }
  if (letters < 3 || (letters == 3 && fold_case(text_.substr(at_, end - at_)) == "мас"))
    return false;
  const std::uint32_t begin = at_;
  at_ = end;
  report_comment(begin);
  return true;
}

// From `begin` to where the lexer stands; the rest of the line goes with it.
void Lexer::report_comment(std::uint32_t begin) {
  Diagnostic comment{Message::UnmarkedComment, from(begin), {std::string(from(begin).text())}};
  comment.fix_it = FixIt{{&file_, begin, begin}, "'", Certainty::Guess};
  line_->broken = true;
  bag_.add(std::move(comment));
  at_ = end_;
}

bool Lexer::is_prose(std::uint32_t at) const {
  return at < end_ && is_cyrillic(code_point_at(text_, at).value);
}

// The signs by which other languages begin a comment; `(` and `;` only before Russian words.
bool Lexer::read_foreign_comment() {
  const std::uint32_t begin = at_;
  const char c = byte(at_);
  const bool sure = c == '#' || (c == '/' && byte(at_ + 1) == '/');
  if (!sure && !((c == '(' || c == ';') && is_prose(skip_blanks(at_ + 1)))) return false;
  at_ = end_;
  while (at_ > begin + 1 && (text_[at_ - 1] == ' ' || text_[at_ - 1] == '\t')) --at_;
  report_comment(begin);
  return true;
}

bool Lexer::read_brackets() {
  const std::uint32_t begin = at_;
  if (byte(at_) != '(') return false;
  const std::size_t close = text_.substr(0, end_).find(')', at_);
  at_ = close == std::string_view::npos ? end_ : static_cast<std::uint32_t>(close) + 1;
  fail(Message::Brackets, from(begin), {});
  return true;
}

bool Lexer::read_semicolon() {
  const std::uint32_t begin = at_;
  if (byte(at_) != ';') return false;
  ++at_;
  line_->broken = true;
  bag_.add({Message::Semicolon, from(begin), {}, {}, FixIt{from(begin), ",", Certainty::Guess}});
  push(WordKind::Comma, begin);
  return true;
}

// `5мм`, `30°`
void Lexer::read_unit() {
  static constexpr std::array<std::string_view, 5> kUnits = {"°", "º", "мм", "mm", "MM"};
  const std::string_view rest = text_.substr(at_, end_ - at_);
  for (const std::string_view unit : kUnits) {
    if (!rest.starts_with(unit)) continue;
    const std::uint32_t begin = at_;
    at_ += static_cast<std::uint32_t>(unit.size());
    line_->broken = true;
    const Range range = from(begin);
    bag_.add({Message::UnitWritten, range, {std::string(unit)}, {}, FixIt{range, ""}});
    return;
  }
}

// A Cyrillic letter that looks like no Latin one was meant for the letter on its key: it is read
// so, in a line that is broken.
bool Lexer::read_wrong_layout() {
  const std::uint32_t begin = at_;
  const CodePoint c = code_point_at(text_, at_);
  const char latin = latin_on_key(c.value);
  if (latin == '\0') return false;
  at_ += c.size;
  const std::string meant(1, latin);
  Diagnostic wrong{Message::WrongLayout, from(begin), {std::string(from(begin).text()), meant}};
  wrong.fix_it = FixIt{from(begin), meant, Certainty::Guess};
  line_->broken = true;
  bag_.add(std::move(wrong));
  at_ = begin;
  read_letter({latin, c.size, false});
  return true;
}

// One report for a whole run of them, since they come in words. Bytes that were no text have been
// reported with the file.
void Lexer::report_unknown_characters() {
  const std::uint32_t begin = at_;
  bool undecodable = false;
  do {
    const CodePoint c = code_point_at(text_, at_);
    undecodable = undecodable || c.value == kReplacementCharacter;
    at_ += c.size;
  } while (at_ < end_ && static_cast<unsigned char>(text_[at_]) >= 0x80 && look(at_).latin == 0);
  if (undecodable && !file_.strays().empty()) {
    line_->broken = true;
  } else {
    fail(Message::UnknownCharacter, from(begin), {std::string(from(begin).text())});
  }
}

}  // namespace dgt::language
