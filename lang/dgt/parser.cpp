// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/parser.h"

#include "lang/dgt/lexer.h"
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

class FileParser {
 public:
  FileParser(const SourceFile& file, DiagnosticBag& bag) : lexer_(file, bag), bag_(bag) {
    program_.file = &file;
    program_.statements.reserve(file.line_count());
  }

  Program run() {
    Lexer::Line line;
    while (lexer_.next_line(line)) add(line);
    for (const std::size_t open : open_loops_) {
      bag_.add({Message::ForWithoutNext, program_.statements[open].range, {}});
      // The loop keeps no body, so that what follows is still read.
      program_.statements[open].broken = true;
      std::get<ForLoop>(program_.statements[open].body).end = open;
    }
    return std::move(program_);
  }

 private:
  void add(Lexer::Line& line) {
    std::vector<Word>& words = line.words;
    // A directive closes its line, and holds for it.
    if (!words.empty() && words.back().is(WordKind::Directive)) {
      Directive directive = directive_of(words.back());
      const bool says_nothing = directive.key.begin == directive.key.end;
      if (!says_nothing) {
        program_.statements.push_back({std::move(directive), words.back().range, false});
      }
      words.pop_back();
    }
    if (words.empty()) return;
    Statement statement = LineParser(words, line.broken, bag_).parse();
    if (std::holds_alternative<ForLoop>(statement.body)) {
      open_loops_.push_back(program_.statements.size());
    } else if (LoopEnd* const end = std::get_if<LoopEnd>(&statement.body)) {
      if (!close_loop(*end, statement.range)) return;
    }
    program_.statements.push_back(std::move(statement));
  }

  bool close_loop(LoopEnd& end, Range range) {
    if (open_loops_.empty()) {
      bag_.add({Message::NextWithoutFor, range, {}});
      return false;
    }
    end.begin = open_loops_.back();
    open_loops_.pop_back();
    std::get<ForLoop>(program_.statements[end.begin].body).end = program_.statements.size();
    return true;
  }

  Lexer lexer_;
  DiagnosticBag& bag_;
  Program program_;
  std::vector<std::size_t> open_loops_;
};

}  // namespace

Program parse(const SourceFile& file, DiagnosticBag& bag) { return FileParser(file, bag).run(); }

std::optional<Statement> parse_spliced(std::span<const Word> words, bool broken,
                                       DiagnosticBag& bag) {
  if (words.empty()) return std::nullopt;
  return LineParser(words, broken, bag).parse();
}

}  // namespace dgt::language
