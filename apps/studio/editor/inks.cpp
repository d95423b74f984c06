// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/editor/inks.h"

#include <QByteArray>
#include <QString>
#include <string_view>

#include "apps/studio/window/theme.h"
#include "lang/dgt/lexer.h"

namespace dgt::studio {
namespace {

using language::NumberForm;
using language::Word;
using language::WordKind;

Ink ink_of_letter(char letter) {
  static constexpr std::string_view kElements = "LCPOK";
  static constexpr std::string_view kCommands = "GMFST";
  static constexpr std::string_view kVariables = "NB";
  if (kElements.find(letter) != std::string_view::npos) return Ink::Element;
  if (kCommands.find(letter) != std::string_view::npos) return Ink::Keyword;
  if (kVariables.find(letter) != std::string_view::npos) return Ink::Variable;
  return Ink::Number;
}

std::optional<Ink> ink_of(const Word& word) {
  switch (word.kind) {
    case WordKind::Letter:
      return ink_of_letter(word.letter);
    case WordKind::Selector:
    case WordKind::Number:
      return Ink::Number;
    case WordKind::For:
    case WordKind::Next:
    case WordKind::Mac:
    case WordKind::Opr:
    case WordKind::Directive:
      return Ink::Keyword;
    case WordKind::QuoteOpen:
    case WordKind::QuoteClose:
    case WordKind::Name:
      return Ink::Variable;
    case WordKind::Operator:
    case WordKind::Equals:
    case WordKind::Comma:
      break;
  }
  return std::nullopt;
}

/// Collects inks of bytes of UTF-8 as ranges of UTF-16.
class Inker {
 public:
  explicit Inker(std::string_view text) : text_(text) {}

  void add(std::size_t begin, std::size_t end, Ink ink) {
    const int from = units_to(begin);
    const int to = units_to(end);
    if (to > from) ranges_.push_back({from, to - from, ink});
  }
  /// What lies between words is blank, or a comment, or no word, which has a message of its own.
  void add_gap(std::size_t begin, std::size_t end) {
    static constexpr std::string_view kBlanks = " \t\v\f\r\n";
    const std::string_view gap = text_.substr(begin, end - begin);
    const std::size_t first = gap.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return;
    add(begin + first, begin + gap.find_last_not_of(kBlanks) + 1, Ink::Comment);
  }
  [[nodiscard]] std::vector<InkedRange> take() { return std::move(ranges_); }

 private:
  // Ranges come from left to right, so the text is counted once.
  int units_to(std::size_t offset) {
    for (; counted_ < offset; ++counted_) {
      const auto byte = static_cast<unsigned char>(text_[counted_]);
      if ((byte & 0xC0U) == 0x80) continue;  // a continuation
      units_ += byte >= 0xF0 ? 2 : 1;
    }
    return units_;
  }

  std::string_view text_;
  std::size_t counted_ = 0;
  int units_ = 0;
  std::vector<InkedRange> ranges_;
};

std::vector<InkedRange> inks_of_dgt(std::string_view bytes) {
  const SourceFile file("", bytes, Encoding::Utf8);
  // Marks of the whole file's beginning or end would move what is counted here.
  if (file.text().size() != bytes.size()) return {};
  DiagnosticBag bag;
  language::Lexer lexer(file, bag);
  language::Lexer::Line line;
  if (!lexer.next_line(line)) return {};
  Inker inker(bytes);
  std::size_t done = 0;
  for (const Word& word : line.words) {
    if (word.range.begin < done) continue;  // quotes that were added
    inker.add_gap(done, word.range.begin);
    done = word.range.end;
    const auto ink = ink_of(word);
    if (!ink) continue;
    const bool of_variable = word.form == NumberForm::Variable && word.kind == WordKind::Letter;
    const std::size_t end = of_variable ? word.number_begin : word.range.end;
    inker.add(word.range.begin, end, *ink);
    if (of_variable) inker.add(end, word.range.end, Ink::Variable);
  }
  inker.add_gap(done, bytes.size());
  return inker.take();
}

bool is_number_sign(QChar c) { return c.isDigit() || c == u'.' || c == u'+' || c == u'-'; }

int end_of_numbers(QStringView line, qsizetype at) {
  while (at < line.size() && (is_number_sign(line[at]) || line[at].isSpace())) ++at;
  while (at > 0 && line[at - 1].isSpace()) --at;
  return static_cast<int>(at);
}

/// Where the comment that begins at `at` ends; `at` when none begins there.
int end_of_comment(QStringView line, qsizetype at, InputLanguage language) {
  const QChar c = line[at];
  if (language == InputLanguage::Gcode && c == u'(') {
    const qsizetype close = line.indexOf(u')', at);
    return static_cast<int>(close < 0 ? line.size() : close + 1);
  }
  const bool is_semicolon_comment =
      language == InputLanguage::Gcode || language == InputLanguage::ThreeB;
  const bool to_the_end = (is_semicolon_comment && c == u';') ||
                          (language == InputLanguage::Poly && c == u'#') ||
                          (language != InputLanguage::Poly && c == u'%');
  return static_cast<int>(to_the_end ? line.size() : at);
}

Ink ink_of_nc_letter(QChar letter) {
  switch (letter.toUpper().unicode()) {
    case u'G':
    case u'M':
    case u'F':
    case u'S':
    case u'T':
      return Ink::Keyword;
    case u'N':
    case u'O':
      return Ink::Comment;  // they number lines and programs and do nothing
    default:
      return Ink::Number;
  }
}

std::vector<InkedRange> inks_of_nc(QStringView line, InputLanguage language) {
  std::vector<InkedRange> ranges;
  for (int at = 0; at < line.size();) {
    const int comment = end_of_comment(line, at, language);
    if (comment > at) {
      ranges.push_back({at, comment - at, Ink::Comment});
      at = comment;
    } else if (line[at].isLetter()) {
      const int end = std::max(end_of_numbers(line, at + 1), at + 1);
      ranges.push_back({at, end - at, ink_of_nc_letter(line[at])});
      at = end;
    } else if (is_number_sign(line[at])) {
      // In ESSI fields with a sign are lengths, those without are codes.
      const bool is_code = language != InputLanguage::Poly && line[at].isDigit() && at == 0;
      const int end = std::max(end_of_numbers(line, at), at + 1);
      ranges.push_back({at, end - at, is_code ? Ink::Keyword : Ink::Number});
      at = end;
    } else {
      ++at;
    }
  }
  return ranges;
}

}  // namespace

std::vector<InkedRange> inks_of(QStringView line, InputLanguage language) {
  if (line.isEmpty() || line.size() > kLongestInkedLine) return {};
  if (language != InputLanguage::Dgt) return inks_of_nc(line, language);
  const QByteArray bytes = line.toUtf8();
  return inks_of_dgt({bytes.data(), static_cast<std::size_t>(bytes.size())});
}

QColor colour_of(Ink ink) {
  const Colours& inks = colours();
  switch (ink) {
    case Ink::Element:
      return inks.element;
    case Ink::Number:
      return inks.number;
    case Ink::Keyword:
      return inks.keyword;
    case Ink::Variable:
      return inks.variable;
    case Ink::Comment:
      break;
  }
  return inks.comment;
}

}  // namespace dgt::studio
