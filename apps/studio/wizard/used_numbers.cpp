// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/wizard/used_numbers.h"

#include <functional>
#include <vector>

#include "lang/dgt/lexer.h"
#include "lang/dgt/syntax.h"

namespace dgt::studio {
namespace {

using language::Word;
using language::WordKind;

constexpr std::string_view kNumbered = "LCPOKNB";

/// A number that names something, and where it stands.
struct Naming {
  char kind = 0;
  int number = 0;
  Range range;  ///< of the digits
  bool defines = false;
};

/// `N3` as a value: the digits stand behind the letter.
std::optional<Naming> naming_by_variable(const Word& word) {
  if (word.form != language::NumberForm::Variable) return std::nullopt;
  Range digits = word.number();
  const auto at = digits.text().find_first_of("0123456789");
  if (at == std::string_view::npos) return std::nullopt;
  digits.begin += static_cast<std::uint32_t>(at);
  return Naming{'N', static_cast<int>(word.digits), digits, false};
}

std::optional<Naming> naming_by_letter(const Word& word) {
  const bool is_numbered = word.kind == WordKind::Letter &&
                           kNumbered.find(word.letter) != std::string_view::npos &&
                           word.form == language::NumberForm::Decimal && word.scale == 0 &&
                           word.digits >= 0 && word.digits <= language::kMaxElementNumber;
  if (!is_numbered) return std::nullopt;
  return Naming{word.letter, static_cast<int>(word.digits), word.number(), false};
}

std::vector<Naming> namings_in(std::string_view program) {
  const auto file = std::make_unique<SourceFile>("program.bgt", program, Encoding::Utf8);
  DiagnosticBag told_elsewhere;
  std::vector<Naming> all;
  language::Lexer lexer(*file, told_elsewhere);
  for (language::Lexer::Line line; lexer.next_line(line);) {
    for (std::size_t i = 0; i < line.words.size(); ++i) {
      const Word& word = line.words[i];
      auto naming = naming_by_letter(word);
      if (!naming) naming = naming_by_variable(word);
      if (!naming) continue;
      naming->defines = i == 0 && line.words.size() > 1 && line.words[1].is(WordKind::Equals);
      naming->range.file = nullptr;  // only its offsets live on
      all.push_back(*naming);
    }
  }
  return all;
}

int most_of(char kind) {
  return kind == 'N' || kind == 'B' ? language::kVariableCount : language::kMaxElementNumber;
}

}  // namespace

UsedNumbers::UsedNumbers(std::string_view program) {
  for (const Naming& naming : namings_in(program)) {
    mentioned_[naming.kind].insert(naming.number);
    if (naming.defines) defined_[naming.kind].insert(naming.number);
  }
}

bool UsedNumbers::has(char kind, int number) const {
  const auto found = mentioned_.find(kind);
  return found != mentioned_.end() && found->second.contains(number);
}

bool UsedNumbers::defines(char kind, int number) const {
  const auto found = defined_.find(kind);
  return found != defined_.end() && found->second.contains(number);
}

int UsedNumbers::next_free(char kind) const {
  for (int number = 1; number <= most_of(kind); ++number) {
    if (!has(kind, number)) return number;
  }
  return 0;
}

void UsedNumbers::add(char kind, int number) {
  mentioned_[kind].insert(number);
  defined_[kind].insert(number);
}

void UsedNumbers::add(const UsedNumbers& others) {
  for (const auto& [kind, numbers] : others.mentioned_)
    mentioned_[kind].insert(numbers.begin(), numbers.end());
  for (const auto& [kind, numbers] : others.defined_)
    defined_[kind].insert(numbers.begin(), numbers.end());
}

std::string with_free_numbers(std::string_view program, UsedNumbers used) {
  const UsedNumbers taken = used;
  const std::vector<Naming> namings = namings_in(program);
  for (const Naming& naming : namings) used.add(naming.kind, naming.number);
  std::map<std::pair<char, int>, int> instead;
  std::string out;
  std::size_t done = 0;
  for (const Naming& naming : namings) {
    if (!taken.has(naming.kind, naming.number)) continue;
    const auto [place, is_new] = instead.try_emplace({naming.kind, naming.number}, naming.number);
    if (const int free = used.next_free(naming.kind); is_new && free != 0) {
      place->second = free;
      used.add(naming.kind, free);
    }
    out += program.substr(done, naming.range.begin - done);
    out += std::to_string(place->second);
    done = naming.range.end;
  }
  out += program.substr(done);
  return out;
}

}  // namespace dgt::studio
