// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/machine.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>
#include <vector>

namespace dgt {
namespace {

using Kind = SettingFault::Kind;

/// A decimal from `least` to `most`.
std::optional<Rational> number(std::string_view text, const Rational& least, const Rational& most) {
  auto value = parse_decimal(text);
  if (!value || *value < least || *value > most) return std::nullopt;
  return value;
}

bool set_unit(Dialect& d, std::string_view text) {
  // parse_decimal takes decimals only, so G-code can spell every multiple; six digits after the
  // point keep those within 64 bits.
  const auto value = number(text, Rational(1, 1'000'000), 100);
  if (!value || Rational(*value * 1'000'000).get_den() != 1) return false;
  Rational steps = *value;
  while (steps.get_den() != 1) steps *= 10;
  if (steps.get_num() > 1'000'000) return false;
  d.unit = *value;
  return true;
}

bool set_decimals(Dialect& d, std::string_view text) {
  if (text.size() != 1 || text[0] < '0' || text[0] > '6') return false;
  d.unit = 1;
  for (char digit = '0'; digit < text[0]; ++digit) d.unit /= 10;
  return true;
}

bool set_feed(RationalPtr& feed, std::string_view text) {
  auto value = number(text, Rational(1, 1000), 1'000'000);
  if (!value) return false;
  feed = shared(*std::move(value));
  return true;
}

bool set_words(std::string& words, std::string_view text) {
  const bool printable = std::all_of(text.begin(), text.end(), [](char c) { return c >= ' '; });
  if (printable) words = text;
  return printable;
}

/// Chooses by name.
template <class T>
bool choose(T& target, std::string_view text,
            std::initializer_list<std::pair<std::string_view, T>> choices) {
  for (const auto& [name, value] : choices) {
    if (name != text) continue;
    target = value;
    return true;
  }
  return false;
}

bool set_arc_degrees(Dialect& d, std::string_view text) {
  // From 120° on, the middle of a radius-form arc runs away from errors in R.
  const auto value = number(text, 10, d.arc_form == ArcForm::Radius ? 150 : 180);
  if (value) d.max_arc_degrees = nearest_double(*value);
  return value.has_value();
}

/// `M21` or `21` as 21; in ESSI what is above 100 would call a subprogram.
std::optional<int> code_number(std::string_view text, Form form) {
  if (!text.empty() && (text.front() == 'M' || text.front() == 'm')) text.remove_prefix(1);
  const int most = form == Form::Essi ? 100 : 999;
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && number >= 0 && number <= most ? std::optional(number) : std::nullopt;
}

bool set_user_codes(Dialect& d, std::string_view text) {
  auto codes = code_ranges(text, d.form);
  if (!codes) return false;
  d.user_codes = *std::move(codes);
  return true;
}

struct Rule {
  SettingKey key;
  bool (*apply)(Dialect&, std::string_view);
};

constexpr std::array kRules{
    Rule{{"unit", "0.000001…100 mm"}, set_unit},
    Rule{{"decimals", "0…6"}, set_decimals},
    Rule{{"feed", "0.001…1000000 mm/min"},
         [](Dialect& d, std::string_view text) { return set_feed(d.feed, text); }},
    Rule{{"default_feed", "0.001…1000000 mm/min"},
         [](Dialect& d, std::string_view text) {
           RationalPtr feed;
           if (!set_feed(feed, text)) return false;
           d.default_feed = *feed;
           return true;
         }},
    Rule{{"torch", "auto|program|none"},
         [](Dialect& d, std::string_view text) {
           return choose<TorchPolicy>(d.torch, text,
                                      {{"auto", TorchPolicy::Automatic},
                                       {"program", TorchPolicy::Program},
                                       {"none", TorchPolicy::None}});
         }},
    Rule{{"torch_on", "\"M3 S1\""},
         [](Dialect& d, std::string_view text) { return set_words(d.torch_on, text); }},
    Rule{{"torch_off", "\"M5\""},
         [](Dialect& d, std::string_view text) { return set_words(d.torch_off, text); }},
    Rule{{"pass_codes", "\"M21 M100-M199\""}, set_user_codes},
    Rule{{"dwell_unit", "s|0.1s|ms"},
         [](Dialect& d, std::string_view text) {
           return choose<DwellUnit>(d.dwell_unit, text,
                                    {{"s", DwellUnit::Seconds},
                                     {"0.1s", DwellUnit::Tenths},
                                     {"ms", DwellUnit::Milliseconds}});
         }},
    Rule{{"compensation", "computed|control"},
         [](Dialect& d, std::string_view text) {
           return choose<Compensation>(
               d.compensation, text,
               {{"computed", Compensation::Computed}, {"control", Compensation::Control}});
         }},
    Rule{{"max_arc_degrees", "10…180° (R: 10…150°)"}, set_arc_degrees},
    Rule{{"radius_mismatch", "0…1 mm"},
         [](Dialect& d, std::string_view text) {
           const auto value = number(text, 0, 1);
           if (value) d.radius_mismatch = *value;
           return value.has_value();
         }},
    Rule{{"line_end", "lf|crlf"},
         [](Dialect& d, std::string_view text) {
           return choose<std::string>(d.line_end, text, {{"lf", "\n"}, {"crlf", "\r\n"}});
         }},
};

constexpr auto kKeys = [] {
  std::array<SettingKey, kRules.size()> keys{};
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = kRules[i].key;
  return keys;
}();

/// Levenshtein's.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, changed});
    }
  }
  return row.back();
}

}  // namespace

std::span<const SettingKey> dialect_settings() { return kKeys; }

std::optional<std::vector<CodeRange>> code_ranges(std::string_view text, Form form) {
  std::vector<CodeRange> codes;
  constexpr std::string_view kBetween = " ,";
  for (std::size_t at = text.find_first_not_of(kBetween); at != std::string_view::npos;
       at = text.find_first_not_of(kBetween, at)) {
    const std::size_t end = std::min(text.find_first_of(kBetween, at), text.size());
    const std::string_view word = text.substr(at, end - at);
    const std::size_t dash = word.find('-');
    const auto first = code_number(word.substr(0, dash), form);
    const auto last =
        dash == std::string_view::npos ? first : code_number(word.substr(dash + 1), form);
    if (!first || !last || *first > *last) return std::nullopt;
    codes.push_back({*first, *last});
    at = end;
  }
  return codes;
}

tl::expected<Setting, SettingFault> parse_setting(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0)
    return tl::unexpected(SettingFault{Kind::NoValue, std::string(text), "", "", ""});
  return Setting{std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

tl::expected<Dialect, SettingFault> with_setting(Dialect dialect, const Setting& setting) {
  for (const Rule& rule : kRules) {
    if (rule.key.key != setting.key) continue;
    if (rule.apply(dialect, setting.value)) return dialect;
    return tl::unexpected(bad_value(rule.key, setting.value));
  }
  std::vector<std::string_view> known;
  for (const SettingKey& key : kKeys) known.push_back(key.key);
  return tl::unexpected(unknown_key(setting, known));
}

SettingFault bad_value(const SettingKey& key, std::string_view value) {
  return {Kind::BadValue, std::string(key.key), std::string(value), "", std::string(key.expected)};
}

SettingFault unknown_key(const Setting& setting, std::span<const std::string_view> known) {
  return {Kind::UnknownKey, setting.key, setting.value,
          std::string(nearest_key(setting.key, known)), ""};
}

std::string_view nearest_key(std::string_view key, std::span<const std::string_view> known) {
  const auto unlikeness = [&](std::string_view candidate) {
    const std::string_view shorter = candidate.substr(0, std::min(key.size(), candidate.size()));
    const auto common = std::mismatch(shorter.begin(), shorter.end(), key.begin()).first;
    return std::pair(edit_distance(key, candidate), shorter.begin() - common);
  };
  const auto best = std::min_element(known.begin(), known.end(),
                                     [&](auto a, auto b) { return unlikeness(a) < unlikeness(b); });
  return best == known.end() ? std::string_view() : *best;
}

}  // namespace dgt
