// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/dialect.h"

#include <algorithm>

#include "kernel/check.h"
#include "post/dialect_file.h"

namespace dgt {
namespace {

/// What is shipped has no faults; the tests read each file for itself.
std::vector<Dialect> shipped() {
  std::vector<Dialect> all;
  for (const ShippedDialect& one : shipped_dialects()) {
    DialectFile file = read_dialect(std::string(one.name), one.text, all);
    DGT_CHECK(file.faults.empty());
    all.push_back(std::move(file.dialect));
  }
  return all;
}

/// `M07` as `M7`.
std::string without_leading_zeros(std::string_view code) {
  const std::size_t digits = code.find_first_of("0123456789");
  if (digits == std::string_view::npos) return std::string(code);
  const std::size_t first = std::min(code.find_first_not_of('0', digits), code.size());
  const bool number = first < code.size() && code[first] >= '0' && code[first] <= '9';
  return std::string(code.substr(0, digits)) +
         std::string(code.substr(number ? first : first - (first > digits ? 1 : 0)));
}

bool contains(const std::vector<std::string>& list, const std::string& code) {
  return std::find(list.begin(), list.end(), code) != list.end();
}

bool is_number_below(const std::string& code, int limit) {
  if (code.empty() || code.size() > 6) return false;
  if (code.find_first_not_of("0123456789") != std::string::npos) return false;
  return std::stoi(code) < limit;
}

bool is_m_code_of(const std::vector<CodeRange>& ranges, const std::string& code) {
  constexpr int kBeyondAll = 1000;
  if (!code.starts_with('M') || !is_number_below(code.substr(1), kBeyondAll)) return false;
  const int number = std::stoi(code.substr(1));
  return std::any_of(ranges.begin(), ranges.end(), [&](const CodeRange& range) {
    return range.first <= number && number <= range.last;
  });
}

bool begins_with_one_of(const std::string& letters, const std::string& code) {
  return !code.empty() && letters.find(code.front()) != std::string::npos;
}

TorchAct torch_act_of(const Dialect& dialect, const std::string& code) {
  if (dialect.torch == TorchPolicy::None) return TorchAct::None;
  const auto is_one = [&](const auto& codes, const auto& own) {
    return contains(codes, code) || contains(own, code);
  };
  if (is_one(dialect.torch_on_codes, dialect.own_torch_on_codes)) return TorchAct::On;
  if (is_one(dialect.torch_off_codes, dialect.own_torch_off_codes)) return TorchAct::Off;
  return TorchAct::None;
}

}  // namespace

const std::vector<Dialect>& dialects() {
  static const std::vector<Dialect> all = shipped();
  return all;
}

const Dialect* find_dialect(std::string_view name) {
  for (const Dialect& d : dialects())
    if (d.name == name) return &d;
  return nullptr;
}

CodeMeaning meaning_of(const Dialect& dialect, std::string_view code) {
  using Kind = CodeMeaning::Kind;
  const std::string plain = without_leading_zeros(code);
  if (plain == "M2" || plain == "M30") return {Kind::End, "", TorchAct::None};
  const TorchAct torch = torch_act_of(dialect, plain);
  if (is_m_code_of(dialect.user_codes, plain))
    return {Kind::Words, dialect.form == Form::Gcode ? plain : plain.substr(1), torch};
  if (contains(dialect.torch_on_codes, plain)) return {Kind::Words, dialect.torch_on, torch};
  if (contains(dialect.torch_off_codes, plain)) return {Kind::Words, dialect.torch_off, torch};
  for (const CodeWord& word : dialect.codes)
    if (word.code == plain) return {Kind::Words, word.words, torch};
  if (is_m_code_of(dialect.known_codes, plain) ||
      is_number_below(plain, dialect.passed_numbers_below))
    return {Kind::Words, plain, torch};
  if (begins_with_one_of(dialect.dropped_letters, plain))
    return {Kind::Dropped, "", TorchAct::None};
  if (begins_with_one_of(dialect.passed_letters, plain)) return {Kind::Words, plain, torch};
  return {};
}

}  // namespace dgt
