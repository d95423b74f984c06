// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dxf/groups.h"

#include <algorithm>
#include <charconv>

namespace dgt {
namespace {

constexpr int kComment = 999;
constexpr int kLeastCode = -5;
constexpr int kMostCode = 1071;

std::optional<int> code_of(std::string_view text) {
  int code = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), code);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (code < kLeastCode || code > kMostCode) return std::nullopt;
  return code;
}

}  // namespace

Range DxfGroups::line(std::uint32_t number) const {
  constexpr std::string_view kBlanks = " \t";
  const std::string_view text = file_.line_text(number);
  const std::uint32_t start = file_.line_start(number);
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {&file_, start, start};
  const std::size_t end = text.find_last_not_of(kBlanks) + 1;
  return {&file_, start + static_cast<std::uint32_t>(begin),
          start + static_cast<std::uint32_t>(end)};
}

std::optional<DxfGroup> DxfGroups::next() {
  while (!broken_ && next_line_ <= file_.line_count()) {
    const Range code_range = line(next_line_);
    const bool has_value = next_line_ < file_.line_count();
    if (code_range.begin == code_range.end && !has_value) break;  // an empty line at the end
    const auto code = code_of(code_range.text());
    if (!code) {
      bag_.add({Message::DxfNoCode, code_range, {std::string(code_range.text())}});
      broken_ = true;
      return std::nullopt;
    }
    if (!has_value) {
      bag_.add({Message::DxfTruncated, code_range, {}});
      broken_ = true;
      return std::nullopt;
    }
    const Range value = line(next_line_ + 1);
    next_line_ += 2;
    if (*code != kComment) return DxfGroup{*code, value};
  }
  return std::nullopt;
}

Rational DxfGroups::number(const DxfGroup& group) {
  const std::string_view text = group.text();
  const auto digits = std::ranges::count_if(text, [](char c) { return c >= '0' && c <= '9'; });
  if (digits > kMaxDxfDigits) {
    bag_.add({Message::NumberTooLong,
              group.value,
              {std::to_string(digits), std::to_string(kMaxDxfDigits)}});
    return 0;
  }
  auto value = parse_scientific(text);
  if (!value) {
    bag_.add(
        {Message::DxfNotANumber, group.value, {std::string(text), std::to_string(group.code)}});
    return 0;
  }
  if (abs(*value) > kMaxDxfNumber) {
    bag_.add({Message::DxfNumberTooLarge,
              group.value,
              {std::string(text), std::to_string(kMaxDxfNumber)}});
    return 0;
  }
  return *std::move(value);
}

long DxfGroups::whole(const DxfGroup& group) {
  const Rational value = number(group);
  if (value.get_den() != 1) {
    bag_.add({Message::DxfNotWhole,
              group.value,
              {std::string(group.text()), std::to_string(group.code)}});
    return 0;
  }
  return value.get_num().get_si();
}

}  // namespace dgt
