// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines are laid out from their words, which are free of blanks and look-alikes already; the parsed
// statement of the line says which of its commas and signs mean something. Comments, which the
// lexer drops, are taken from the text behind the last word.
#include "lang/dgt/formatter.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "kernel/check.h"
#include "lang/dgt/dump.h"
#include "lang/dgt/lexer.h"
#include "lang/dgt/parser.h"
#include "lang/text/utf8.h"

namespace dgt::language {
namespace {

constexpr std::size_t kIndent = 2;
// Deeper loops are indented no further, so that the layout of hostile nesting stays short.
constexpr std::size_t kDeepestIndent = 20;
constexpr std::size_t kGap = 2;  // between code and its comment
// Code that is wider takes no part in aligning: one long line must not push the comments of its
// neighbours off the screen.
constexpr std::size_t kWidestAligned = 60;

constexpr std::string_view kBlanks = " \t\v\f";

struct Row {
  std::string code;
  std::string_view comment;
  std::size_t indent = 0;

  [[nodiscard]] bool is_blank() const { return code.empty() && comment.empty(); }
  [[nodiscard]] bool has_both() const { return !code.empty() && !comment.empty(); }
  [[nodiscard]] std::size_t width() const { return indent + count_code_points(code); }
  [[nodiscard]] bool is_aligned() const { return has_both() && width() <= kWidestAligned; }
};

// --- which words stay ---------------------------------------------------------------------------

bool is_any(const Word& word, std::initializer_list<WordKind> kinds) {
  return std::find(kinds.begin(), kinds.end(), word.kind) != kinds.end();
}

// `K1=` says no more than `K1`.
void drop_equals_of_contour(std::vector<Word>& words) {
  if (words.size() > 1 && words[0].is_letter('K') && words[1].is(WordKind::Equals)) {
    words.erase(words.begin() + 1);
  }
}

void drop_commas(std::vector<Word>& words) {
  std::erase_if(words, [](const Word& w) { return w.is(WordKind::Comma); });
}

// A plus with nothing to add to: at the beginning of a value.
void drop_signs_without_use(std::vector<Word>& words) {
  std::vector<Word> kept;
  for (const Word& word : words) {
    const bool begins_value =
        !kept.empty() && is_any(kept.back(), {WordKind::Equals, WordKind::Operator, WordKind::Comma,
                                              WordKind::Name, WordKind::For});
    if (word.is(WordKind::Operator) && word.letter == '+' && begins_value) continue;
    kept.push_back(word);
  }
  words = std::move(kept);
}

// What of the words of a statement is worth writing.
struct Essence {
  std::vector<Word>& words;

  void operator()(const Definition&) const { drop_commas(words); }
  void operator()(const ContourStart&) const {
    drop_equals_of_contour(words);
    drop_commas(words);
  }
  void operator()(const ItemLine& line) const {
    if (!line.has_comma) return;
    const Word comma = *std::ranges::find(words, WordKind::Comma, &Word::kind);
    drop_commas(words);
    words.push_back(comma);
  }
  void operator()(const NumberAssignment&) const { drop_signs_without_use(words); }
  void operator()(const ForLoop&) const { drop_signs_without_use(words); }
  void operator()(const MacroCall&) const { drop_signs_without_use(words); }
  // What its commas mean shows only with the texts in place.
  void operator()(const SplicedLine&) const { drop_equals_of_contour(words); }
  void operator()(const TextAssignment&) const {}
  void operator()(const LoopEnd&) const {}
  void operator()(const DefinitionFile&) const {}
  void operator()(const Directive&) const { DGT_CHECK(false); }
};

// --- a line of words ----------------------------------------------------------------------------

bool blank_between(const Word& a, const Word& b, bool is_macro_call) {
  if (a.is(WordKind::Name)) return true;  // nothing else ends it
  if (is_any(b, {WordKind::Comma, WordKind::Equals, WordKind::QuoteClose})) return false;
  if (is_any(a, {WordKind::Equals, WordKind::QuoteOpen, WordKind::Operator})) return false;
  if (a.is(WordKind::Comma)) {
    return !is_macro_call && !is_any(b, {WordKind::Number, WordKind::Operator});
  }
  if (b.is(WordKind::Operator)) return !is_any(a, {WordKind::Letter, WordKind::Number});
  return true;
}

std::string joined(const std::vector<Word>& words) {
  const bool is_macro_call = !words.empty() && words.front().is(WordKind::Mac);
  std::string line;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0 && blank_between(words[i - 1], words[i], is_macro_call)) line += ' ';
    line += to_text(words[i]);
  }
  return line;
}

// The comment of a line, from its mark; only blanks stand between it and the words.
std::string_view comment_of(const Lexer::Line& line) {
  std::uint32_t code_end = line.range.begin;
  for (const Word& word : line.words) {
    if (!word.is(WordKind::Directive)) code_end = word.range.end;
  }
  std::string_view rest = Range{line.range.file, code_end, line.range.end}.text();
  const std::size_t mark = rest.find('\'');
  if (mark == std::string_view::npos) return {};
  rest.remove_prefix(mark);
  return rest.substr(0, rest.find_last_not_of(kBlanks) + 1);
}

// --- all lines ----------------------------------------------------------------------------------

class Layout {
 public:
  explicit Layout(const Program& program) : program_(program) {}

  std::string run() {
    DiagnosticBag known;  // to the caller, from parsing
    Lexer lexer(*program_.file, known);
    for (Lexer::Line line; lexer.next_line(line);) add(line);
    while (!rows_.empty() && rows_.back().is_blank()) rows_.pop_back();
    std::string text;
    for (std::size_t i = 0; i < rows_.size();) i = write_run(text, i);
    return text;
  }

 private:
  void add(Lexer::Line& line) {
    Row row;
    row.comment = comment_of(line);
    std::erase_if(line.words, [](const Word& w) { return w.is(WordKind::Directive); });
    if (!line.words.empty()) {
      const Statement::Body& body = next_statement();
      if (std::holds_alternative<LoopEnd>(body)) --depth_;
      std::visit(Essence{line.words}, body);
      row.code = joined(line.words);
      row.indent = indent();
      if (std::holds_alternative<ForLoop>(body)) ++depth_;
    } else {
      row.indent = indent();
    }
    const bool is_further_blank = row.is_blank() && (rows_.empty() || rows_.back().is_blank());
    if (!is_further_blank) rows_.push_back(std::move(row));
  }

  // Every line with words has made one statement, besides those of the directives.
  const Statement::Body& next_statement() {
    const auto& statements = program_.statements;
    while (std::holds_alternative<Directive>(statements.at(next_).body)) ++next_;
    return statements.at(next_++).body;
  }

  [[nodiscard]] std::size_t indent() const { return kIndent * std::min(depth_, kDeepestIndent); }

  // Writes the row, or the run of rows whose comments stand in one column; returns what follows.
  std::size_t write_run(std::string& text, std::size_t begin) const {
    std::size_t end = begin;
    std::size_t widest = 0;
    for (; end < rows_.size() && rows_[end].is_aligned(); ++end) {
      widest = std::max(widest, rows_[end].width());
    }
    if (end == begin) {
      write(text, rows_[begin], rows_[begin].width());
      return begin + 1;
    }
    for (std::size_t i = begin; i < end; ++i) write(text, rows_[i], widest);
    return end;
  }

  static void write(std::string& text, const Row& row, std::size_t widest) {
    if (!row.is_blank()) text.append(row.indent, ' ');
    text += row.code;
    if (row.has_both()) text.append(widest - row.width() + kGap, ' ');
    text.append(row.comment) += '\n';
  }

  const Program& program_;
  std::vector<Row> rows_;
  std::size_t next_ = 0;  // statement
  std::size_t depth_ = 0;
};

}  // namespace

std::optional<std::string> format(const SourceFile& file, DiagnosticBag& bag) {
  const std::size_t known = bag.error_count();
  const Program program = parse(file, bag);
  if (bag.error_count() > known) return std::nullopt;
  return Layout(program).run();
}

}  // namespace dgt::language
