// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/parser.h"

#include "lang/dgt/line_parser.h"

namespace dgt::language {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

Range range_within(const Range& outer, std::string_view part) {
  const auto begin = static_cast<std::uint32_t>(part.data() - outer.file->text().data());
  return {outer.file, begin, begin + static_cast<std::uint32_t>(part.size())};
}

Directive directive_of(const Word& word) {
  const std::string_view text = trimmed(word.number().text());
  if (text.empty()) return {behind(word.range), behind(word.range)};
  const std::size_t blank = std::min(text.find_first_of(" \t="), text.size());
  const std::string_view value = trimmed(text.substr(std::min(blank + 1, text.size())));
  const Range key = range_within(word.range, text.substr(0, blank));
  return {key, value.empty() ? behind(key) : range_within(word.range, value)};
}

}  // namespace

bool ProgramReader::next(Program& piece) {
  piece.file = &file_;
  piece.statements.clear();
  while (piece.statements.empty() || !open_loops_.empty()) {
    if (read_line(piece)) continue;
    give_up_open_loops(piece);
    break;
  }
  return !piece.statements.empty();
}

void ProgramReader::read_rest(Program& program) {
  program.file = &file_;
  while (read_line(program)) continue;
  give_up_open_loops(program);
}

bool ProgramReader::read_line(Program& program) {
  if (!lexer_.next_line(line_)) return false;
  std::vector<Word>& words = line_.words;
  // A directive closes its line, and holds for it.
  if (!words.empty() && words.back().is(WordKind::Directive)) {
    Directive directive = directive_of(words.back());
    const bool says_nothing = directive.key.begin == directive.key.end;
    if (!says_nothing) {
      program.statements.push_back({std::move(directive), words.back().range, false});
    }
    words.pop_back();
  }
  std::span<const Word> rest = words;
  while (!rest.empty()) {
    const std::size_t count = first_statement(rest);
    std::size_t own = count;  // a comma before what does not belong here separates nothing
    while (count < rest.size() && own > 1 && rest[own - 1].is(WordKind::Comma)) --own;
    add_statement(rest.first(own), program);
    rest = rest.subspan(count);
    if (rest.empty()) break;
    bag_.add({Message::SecondStatement, rest[0].range, {std::string(rest[0].range.text())}});
  }
  return true;
}

void ProgramReader::add_statement(std::span<const Word> words, Program& program) {
  Statement statement = LineParser(words, line_.broken, bag_).parse();
  if (std::holds_alternative<ForLoop>(statement.body)) {
    open_loops_.push_back(program.statements.size());
  } else if (LoopEnd* const end = std::get_if<LoopEnd>(&statement.body)) {
    if (!close_loop(program, *end, statement.range)) return;
  }
  program.statements.push_back(std::move(statement));
}

bool ProgramReader::close_loop(Program& program, LoopEnd& end, const Range& range) {
  if (open_loops_.empty()) {
    bag_.add({Message::NextWithoutFor, range, {}});
    return false;
  }
  end.begin = open_loops_.back();
  open_loops_.pop_back();
  std::get<ForLoop>(program.statements[end.begin].body).end = program.statements.size();
  return true;
}

// At the end of the file. Such a loop keeps no body, so that what follows it is still executed.
void ProgramReader::give_up_open_loops(Program& program) {
  for (const std::size_t open : open_loops_) {
    Statement& statement = program.statements[open];
    bag_.add({Message::ForWithoutNext, statement.range, {}});
    statement.broken = true;
    std::get<ForLoop>(statement.body).end = open;
  }
  open_loops_.clear();
}

Program parse(const SourceFile& file, DiagnosticBag& bag) {
  Program program;
  program.statements.reserve(file.line_count());
  ProgramReader(file, bag).read_rest(program);
  return program;
}

std::optional<Statement> parse_spliced(std::span<const Word> words, bool broken,
                                       DiagnosticBag& bag) {
  if (words.empty()) return std::nullopt;
  return LineParser(words, broken, bag).parse();
}

}  // namespace dgt::language
